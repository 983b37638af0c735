# Draws a layered graph of libraries as SVG. A line of input: library, folder, libraries it uses.
# Long edges get a bend in every row that they pass, so that no edge runs through a box.

function group_of(folder) {
  if (folder ~ /^model\/base\//) return "base"
  if (folder ~ /^model\/(comparison|lane|scene|design)/) return "scene"
  if (folder ~ /^model\/judge\// || folder == "verilator_tb") return "judges"
  if (folder ~ /^model\//) return "cost and plan"
  if (folder ~ /^generator\/faces\//) return "faces"
  return "generator"
}

# The length of the longest way down from a node.
function row_of(node,   other, row) {
  if (node in row_known) return row_known[node]
  row = 0
  for (other in folder)
    if ((node, other) in uses && row_of(other) >= row) row = row_of(other) + 1
  return row_known[node] = row
}

# 1 if some way of two edges or more leads from a node to another one.
function is_implied(from, to,   between) {
  for (between in folder)
    if ((from, between) in uses && reaches(between, to)) return 1
  return 0
}

function reaches(from, to,   between) {
  if ((from, to) in reach_known) return reach_known[from, to]
  reach_known[from, to] = (from, to) in uses
  for (between in folder)
    if ((from, between) in uses && reaches(between, to)) reach_known[from, to] = 1
  return reach_known[from, to]
}

function add_node(node, row, node_width) {
  in_row[row, count[row] + 0] = node
  count[row]++
  row_at[node] = row
  width[node] = node_width
}

function add_edge(upper, lower) {
  down[upper, downs[upper]++ + 0] = lower
  up[lower, ups[lower]++ + 0] = upper
}

# The mean x of a node's neighbours below (direction 0), above (1) or both (2); its own x if none.
function mean_x(node, direction,   i, sum, n) {
  if (direction != 1) for (i = 0; i < downs[node]; i++) { sum += x[down[node, i]]; n++ }
  if (direction != 0) for (i = 0; i < ups[node]; i++) { sum += x[up[node, i]]; n++ }
  return n > 0 ? sum / n : x[node]
}

function distance(left, right) { return (width[left] + width[right]) / 2 + gap }

# Puts the nodes of a row in the order of what they want, and then as near to it as they fit.
function settle(row, direction, may_reorder,   i, j, node, moved, pass) {
  for (i = 0; i < count[row]; i++) wanted[in_row[row, i]] = mean_x(in_row[row, i], direction)
  if (may_reorder)
    for (i = 1; i < count[row]; i++) {
      node = in_row[row, i]
      for (j = i; j > 0 && wanted[in_row[row, j - 1]] > wanted[node]; j--)
        in_row[row, j] = in_row[row, j - 1]
      in_row[row, j] = node
    }
  for (i = 0; i < count[row]; i++) x[in_row[row, i]] = wanted[in_row[row, i]]
  for (pass = 0; pass < 60; pass++)
    for (i = 1; i < count[row]; i++) {
      moved = distance(in_row[row, i - 1], in_row[row, i]) - \
              (x[in_row[row, i]] - x[in_row[row, i - 1]])
      if (moved > 0) {
        x[in_row[row, i - 1]] -= moved / 2
        x[in_row[row, i]] += moved / 2
      }
    }
  for (i = 1; i < count[row]; i++)
    if (x[in_row[row, i]] < x[in_row[row, i - 1]] + distance(in_row[row, i - 1], in_row[row, i]))
      x[in_row[row, i]] = x[in_row[row, i - 1]] + distance(in_row[row, i - 1], in_row[row, i])
}

function crossings(   row, i, j, k, l, a, b, n) {
  for (row = 1; row <= top; row++)
    for (i = 0; i < count[row]; i++)
      for (j = i + 1; j < count[row]; j++) {
        a = in_row[row, i]; b = in_row[row, j]
        for (k = 0; k < downs[a]; k++)
          for (l = 0; l < downs[b]; l++) if (x[down[a, k]] > x[down[b, l]]) n++
      }
  return n + 0
}

function keep(   row, i) {
  for (row = 0; row <= top; row++)
    for (i = 0; i < count[row]; i++) {
      best_in_row[row, i] = in_row[row, i]
      best_x[in_row[row, i]] = x[in_row[row, i]]
    }
}

function y_of(row) { return 34 + (top - row) * step }

BEGIN {
  step = 68; height = 26; gap = 14
  colour["base"] = "#eeeeee"
  colour["scene"] = "#eef4e8"
  colour["cost and plan"] = "#fdf6d8"
  colour["judges"] = "#f6e8f1"
  colour["generator"] = "#e8f1fa"
  colour["faces"] = "#fdeedd"
}

{
  library[NR] = $1
  folder[$1] = $2
  for (i = 3; i <= NF; i++) uses[$1, $i] = 1
}

END {
  for (n = 1; n <= NR; n++) {
    row = row_of(library[n])
    if (row > top) top = row
    add_node(library[n], row, 7.1 * length(folder[library[n]]) + 18)
  }
  for (n = 1; n <= NR; n++)
    for (m = 1; m <= NR; m++)
      if ((library[n], library[m]) in uses && !is_implied(library[n], library[m])) {
        upper = library[n]
        for (row = row_known[library[n]] - 1; row > row_known[library[m]]; row--) {
          bend = "bend " n " " m " " row
          add_node(bend, row, 10)
          add_edge(upper, bend)
          upper = bend
        }
        add_edge(upper, library[m])
      }

  for (row = 0; row <= top; row++)
    for (i = 0; i < count[row]; i++) x[in_row[row, i]] = 120 * (i - count[row] / 2)
  fewest = -1
  for (sweep = 0; sweep < 24; sweep++) {
    for (row = 1; row <= top; row++) settle(row, 0, 1)
    for (row = top - 1; row >= 0; row--) settle(row, 1, 1)
    found = crossings()
    if (fewest < 0 || found < fewest) { fewest = found; keep() }
  }
  for (row = 0; row <= top; row++)
    for (i = 0; i < count[row]; i++) {
      in_row[row, i] = best_in_row[row, i]
      x[in_row[row, i]] = best_x[in_row[row, i]]
    }
  for (sweep = 0; sweep < 40; sweep++) {
    for (row = 0; row <= top; row++) settle(row, 2, 0)
    for (row = top; row >= 0; row--) settle(row, 2, 0)
  }

  least = 1e9; most = -1e9
  for (node in x) {
    if (x[node] - width[node] / 2 < least) least = x[node] - width[node] / 2
    if (x[node] + width[node] / 2 > most) most = x[node] + width[node] / 2
  }
  wide = most - least + 24
  if (wide < 760) { least -= (760 - wide) / 2; wide = 760 }
  high = y_of(0) + height + 50
  printf "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 %.0f %.0f\" ", wide, high
  print "font-family=\"DejaVu Sans, Helvetica, Arial, sans-serif\" font-size=\"12\">"
  print "<title>Folders of mixcmp: each stands on those that its lines lead down to</title>"
  printf "<rect x=\"0\" y=\"0\" width=\"%.0f\" height=\"%.0f\" fill=\"#fff\"/>\n", wide, high
  for (row = top; row > 0; row--)
    for (i = 0; i < count[row]; i++) {
      upper = in_row[row, i]
      for (k = 0; k < downs[upper]; k++) draw_wire(upper, down[upper, k])
    }
  for (row = top; row >= 0; row--)
    for (i = 0; i < count[row]; i++) if (in_row[row, i] in folder) draw_box(in_row[row, i])
  n = split("base,scene,cost and plan,judges,generator,faces", names, ",")
  for (i = 1; i <= n; i++) {
    left = wide / 2 - 345 + 115 * (i - 1)
    draw_rectangle(left, high - 28, 14, 14, colour[names[i]])
    printf "<text fill=\"#555\" font-size=\"11.5\" x=\"%.0f\" y=\"%.0f\">%s</text>\n", left + 20, high - 17, names[i]
  }
  print "</svg>"
}

# The x at which an edge leaves or enters a box: in the order of the neighbours, a little apart.
function port_x(node, other, downward,   i, n, before, neighbour) {
  if (!(node in folder)) return x[node] - least + 12
  n = downward ? downs[node] : ups[node]
  for (i = 0; i < n; i++) {
    neighbour = downward ? down[node, i] : up[node, i]
    if (x[neighbour] < x[other]) before++
  }
  return x[node] - least + 12 + (before - (n - 1) / 2) * (n > 5 ? 7 : 11)
}

function draw_wire(upper, lower,   from_x, from_y, to_x, to_y, middle) {
  from_x = port_x(upper, lower, 1); to_x = port_x(lower, upper, 0)
  from_y = y_of(row_at[upper]) + height / 2
  to_y = y_of(row_at[lower]) - height / 2
  middle = (from_y + to_y) / 2
  printf "<path stroke=\"#777\" stroke-width=\"1.2\" fill=\"none\" d=\"M%.1f,%.1f C%.1f,%.1f %.1f,%.1f %.1f,%.1f%s\"/>\n", \
         from_x, from_y, from_x, middle, to_x, middle, to_x, to_y, \
         lower in folder ? "" : " v" height
}

function draw_rectangle(left, upper, wide, high, fill) {
  printf "<rect stroke=\"#333\" stroke-width=\"1.3\" x=\"%.1f\" y=\"%.1f\" width=\"%.1f\" height=\"%d\" rx=\"4\" ", \
         left, upper, wide, high
  printf "fill=\"%s\"/>\n", fill
}

function draw_box(node,   left) {
  left = x[node] - least + 12 - width[node] / 2
  draw_rectangle(left, y_of(row_at[node]) - height / 2, width[node], height,
                 colour[group_of(folder[node])])
  printf "<text x=\"%.1f\" y=\"%.1f\" text-anchor=\"middle\">%s</text>\n", \
         left + width[node] / 2, y_of(row_at[node]) + 4, folder[node]
}
