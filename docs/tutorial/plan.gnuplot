# Draws plan.csv of `mixcmp optimise --csv`. alone: G comparisons per second of references alone.
set terminal svg size 700,340 noenhanced \
  font "DejaVu Sans,Helvetica,Arial,sans-serif,12" background "white"
set datafile separator ","
set style fill solid 0.8 border rgb "#333333"
set boxwidth 0.5
set xtics 1 nomirror
set ytics nomirror
set xlabel "L: digits of the lanes"
set ylabel "G comparisons per second"
stats "plan.csv" using 1 skip 1 nooutput
stats "plan.csv" using ($6 / 1e9) skip 1 name "rate" nooutput
set xrange [STATS_min - 0.8 : STATS_max + 0.8]
set yrange [0 : rate_max * 1.25]
set key outside right top
plot "plan.csv" skip 1 using 1:($6 / 1e9) with boxes linecolor rgb "#9cc4e4" \
       title "lanes, p_L x p_H", \
     "" skip 1 using 1:($6 / 1e9 + rate_max * 0.06):(sprintf("%d x %d", $2, $3)) \
       with labels notitle, \
     alone with lines linewidth 2 linecolor rgb "#e07b1a" title "references alone"
