# Draws one recomputed comparison of a lane as SVG, out of a VCD file of a system at full rate:
# where it and its neighbours enter, where the next one leaves, where it leaves itself.
# Variables: lane, the lane's number; entry_time and exit_time, the GTKWave markers A and B.

# 1 if the scope is the channel of the lane; its streams have one lane's width.
function in_channel() { return scope ~ ("\\.g_lanes\\[" lane "\\]\\.channel$") }

function bits_to_number(bits,   i, number) {
  for (i = 1; i <= length(bits); i++) number = 2 * number + substr(bits, i, 1)
  return number + 0
}

# A cycle is what its closing edge samples: the values before the changes of that instant.
function end_cycle(   tag) {
  cycle++
  for (name in is_stream) seen[cycle, name] = value[name]
  if (seen[cycle, "s_axis_tvalid"] == 1 && seen[cycle, "s_axis_tready"] == 1) {
    tag = seen[cycle, "s_axis_tuser"]
    number_of[tag] = accepted++
    entry_cycle[tag] = cycle
  }
  if (seen[cycle, "m_axis_tvalid"] == 1 && seen[cycle, "m_axis_tready"] == 1) {
    tag = seen[cycle, "m_axis_tuser"]
    exit_cycle[tag] = cycle
    result_of[tag] = bits_to_number(seen[cycle, "m_axis_tdata"])
  }
}

function end_instant(   i, rises) {
  for (i = 1; i <= changes; i++) if (changed[i] == clock && new_value[i] == 1) rises = 1
  if (rises) {
    end_cycle()
    if (now <= entry_time) entered = cycle + 1
    if (now <= exit_time) left = cycle + 1
  }
  for (i = 1; i <= changes; i++)
    if (changed[i] in name_of) value[name_of[changed[i]]] = new_value[i]
  changes = 0
}

BEGIN {
  split("s_axis_tvalid s_axis_tready s_axis_tuser m_axis_tvalid m_axis_tready m_axis_tuser " \
        "m_axis_tdata", names, " ")
  for (i in names) is_stream[names[i]] = 1
}

$1 == "$scope" { depth++; path[depth] = $3; scope = scope "." $3; next }
$1 == "$upscope" {
  scope = substr(scope, 1, length(scope) - length(path[depth]) - 1)
  depth--
  next
}
$1 == "$var" {
  if ($5 == "aclk" && depth == 1) clock = $4
  if (in_channel() && $5 in is_stream) name_of[$4] = $5
  next
}
/^#/ {
  end_instant()
  now = substr($1, 2) + 0
  if (now > exit_time + 40) exit
  next
}
/^b/ { changed[++changes] = $2; new_value[changes] = substr($1, 2); next }
/^[01xz]/ { changed[++changes] = substr($1, 2); new_value[changes] = substr($1, 1, 1) }

function text(x, y, class, words) {
  printf "<text class=\"%s\" x=\"%.1f\" y=\"%.1f\">%s</text>\n", class, x, y, words
}

function fill_of(tag) {
  if (tag == recomputed_tag) return "#f9cf9c"
  return tag == decided_tag ? "#bcd9f2" : "#fff"
}

# A bit over the cycles of a window: a line of two levels.
function draw_bit(name, first, last, left, y,   c, level, d) {
  d = sprintf("M%.1f,%.1f", left, y + (seen[first, name] == 1 ? 4 : 20))
  for (c = first; c <= last; c++) {
    level = y + (seen[c, name] == 1 ? 4 : 20)
    d = d sprintf(" L%.1f,%.1f L%.1f,%.1f", left + (c - first) * step + 2, level, \
                  left + (c - first + 1) * step - 2, level)
  }
  printf "<path class=\"line\" d=\"%s\"/>\n", d
}

function draw_clock(first, last, left, y,   c, at, d) {
  for (c = first; c <= last; c++) {
    at = left + (c - first) * step
    d = d sprintf("%s%.1f,%.1f V%.1f H%.1f V%.1f H%.1f", c == first ? "M" : " L", at, y + 20, \
                  y + 4, at + step / 2, y + 20, at + step)
  }
  printf "<path class=\"line\" d=\"%s\"/>\n", d
}

# A bus over the cycles of a window: a hexagon for each beat, grey where nothing is valid.
function draw_bus(valid, name, tag_name, first, last, left, y,   c, at, tag, words, fill) {
  for (c = first; c <= last; c++) {
    at = left + (c - first) * step
    tag = seen[c, tag_name]
    fill = seen[c, valid] == 1 ? fill_of(tag) : "#ddd"
    words = ""
    if (seen[c, valid] == 1)
      words = name == "m_axis_tdata" ? sprintf("%x", bits_to_number(seen[c, name])) : number_of[tag]
    printf "<path class=\"line\" fill=\"%s\" ", fill
    printf "d=\"M%.1f,%.1f l3,-8 h%.1f l3,8 l-3,8 h-%.1f z\"/>\n", at, y + 12, step - 6, step - 6
    text(at + step / 2, y + 16, "beat", words)
  }
}

function draw_window(first, last, left,   right) {
  right = left + (last - first + 1) * step
  draw_clock(first, last, left, 40)
  draw_bit("s_axis_tvalid", first, last, left, 76)
  draw_bit("s_axis_tready", first, last, left, 106)
  draw_bus("s_axis_tvalid", "s_axis_tuser", "s_axis_tuser", first, last, left, 136)
  draw_bit("m_axis_tvalid", first, last, left, 178)
  draw_bit("m_axis_tready", first, last, left, 208)
  draw_bus("m_axis_tvalid", "m_axis_tuser", "m_axis_tuser", first, last, left, 238)
  draw_bus("m_axis_tvalid", "m_axis_tdata", "m_axis_tuser", first, last, left, 268)
  for (c = first; c <= last; c++)
    text(left + (c - first + 0.5) * step, 32, "cycle", c - entered)
}

END {
  end_instant()
  for (tag in exit_cycle)
    if (exit_cycle[tag] == left && int(result_of[tag] / 4) % 2 == 1) recomputed_tag = tag
  for (tag in exit_cycle)
    if (entry_cycle[tag] > entered && int(result_of[tag] / 4) % 2 == 0 &&
        (decided_tag == "" || entry_cycle[tag] < entry_cycle[decided_tag])) decided_tag = tag
  if (recomputed_tag == "" || decided_tag == "") {
    print "waves.awk: no recomputed comparison left lane " lane " at marker B" >"/dev/stderr"
    exit 1
  }
  step = 28; start = 126; apart = 22
  first[1] = entered - 2; last[1] = entered + 5
  first[2] = exit_cycle[decided_tag] - 3; last[2] = exit_cycle[decided_tag] + 4
  first[3] = left - 4; last[3] = left + 3
  wide = start + 24 * step + 2 * apart + 14

  printf "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 %d 352\" ", wide
  print "font-family=\"DejaVu Sans, Helvetica, Arial, sans-serif\" font-size=\"12\">"
  print "<title>A recomputed comparison in a lane's streams, overtaken by a decided one</title>"
  print "<style>"
  print ".line{stroke:#333;stroke-width:1.2}"
  print "path.line:not([fill]){fill:none}"
  print ".name{text-anchor:end}"
  print ".beat{text-anchor:middle;font-size:11px}"
  print ".cycle{text-anchor:middle;font-size:10.5px;fill:#777}"
  print ".note{font-size:11.5px;fill:#555}"
  print "</style>"
  printf "<rect x=\"0\" y=\"0\" width=\"%d\" height=\"352\" fill=\"#fff\"/>\n", wide
  text(start - 12, 32, "name note", "cycle")
  split("aclk:40 s_axis_tvalid:76 s_axis_tready:106 s_axis_tuser:136 m_axis_tvalid:178 " \
        "m_axis_tready:208 m_axis_tuser:238 m_axis_tdata:268", rows, " ")
  for (i = 1; i in rows; i++) {
    split(rows[i], row, ":")
    text(start - 12, row[2] + 16, "name", row[1])
  }
  for (i = 1; i <= 3; i++) {
    at = start + (i - 1) * (8 * step + apart)
    draw_window(first[i], last[i], at)
    if (i > 1)
      printf "<path stroke=\"#999\" stroke-dasharray=\"2 3\" d=\"M%.1f,24 V296\"/>\n", \
             at - apart / 2
  }
  draw_key(start, 310, "#f9cf9c")
  text(start + 22, 320, "note", \
       sprintf("number %d of lane %d: undecided, recomputed, %d cycles; tdata %x: recomputed, %s", \
               number_of[recomputed_tag], lane, left - entered, result_of[recomputed_tag], \
               word(result_of[recomputed_tag])))
  draw_key(start, 330, "#bcd9f2")
  text(start + 22, 340, "note", \
       sprintf("number %d, accepted later: decided by the lane, %d cycles; tdata %x: %s", \
               number_of[decided_tag], exit_cycle[decided_tag] - entry_cycle[decided_tag], \
               result_of[decided_tag], word(result_of[decided_tag])))
  print "</svg>"
}

function draw_key(x, y, fill) {
  printf "<rect class=\"line\" x=\"%d\" y=\"%d\" ", x, y
  printf "width=\"14\" height=\"12\" fill=\"%s\"/>\n", fill
}

function word(result) {
  split("less equal greater unordered", verdicts, " ")
  return verdicts[result % 4 + 1]
}
