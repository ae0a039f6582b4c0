# Errors at 2 ms against the time of the element forces; variables csv, chart, tip (mm), work (J) from run.sh.
set datafile separator ','
set terminal svg size 1000,520 font 'sans,12' background 'white'
set output chart
set multiplot layout 1, 2
set logscale xy
set xrange [0.002:10]
set xlabel 'element forces to 2 ms, s (one core)'
set format y '%g'
set grid
set key bottom left font ',10'
pick(kind, layers) = sprintf("< grep '^impulse,%s,[0-9]*x[0-9]*x%d,' %s", kind, layers, csv)
error(value, reference) = 100. * abs(value / reference - 1.)
do for [panel = 1:2] {
  column_ = panel == 1 ? 5 : 6
  reference = panel == 1 ? tip : work
  set ylabel panel == 1 ? 'error of the tip deflection, %' : 'error of the plastic work, %'
  if (panel == 1) { set yrange [0.1:30]; unset key } else { set yrange [0.1:90]; set key }
  plot pick('shell', 1) using 10:(error(column(column_), reference)) with linespoints title 'shell, 5 points', \
       pick('one-point', 1) using 10:(error(column(column_), reference)) with linespoints title 'one-point brick, 1 layer', \
       pick('one-point', 4) using 10:(error(column(column_), reference)) with linespoints title 'one-point brick, 4 layers', \
       pick('quadratic-g2xg5', 1) using 10:(error(column(column_), reference)) with linespoints lw 2 title 'quadratic 2 x 2 x 5', \
       pick('quadratic-g2xg3', 2) using 10:(error(column(column_), reference)) with linespoints lw 2 title 'quadratic 2 x 2 x 3, 2 layers', \
       pick('quadratic-g3', 1) using 10:(error(column(column_), reference)) with linespoints title 'quadratic, Gauss 3', \
       pick('quadratic-gl3', 1) using 10:(error(column(column_), reference)) with linespoints title 'quadratic, Lobatto 3'
}
