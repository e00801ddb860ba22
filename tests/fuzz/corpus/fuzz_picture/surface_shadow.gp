set hidden3d area
set shadow
set hatch 3,1
set isosamples 5
set view from 1,1,2
splot x*x-y*y, NaN+x, sin(x)
