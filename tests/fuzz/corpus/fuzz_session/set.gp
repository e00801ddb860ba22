set machine steps 80,100 speed 90 lift 0.1 invert xy swap corexy size 300,200
set paper a3 portrait margin 5
set view from 6,8,3 to 0,0,0
set view 60,30,1,1
set xrange [*:5]; set zrange [3:-2]
set hidden3d horizon infinite
show all; help set view; reset
set autoscale xy; set xyplane at 0; set dummy u,v
set datafile separator ';'; unset machine
