set hidden3d outline
set view from 0.1,0.2,3
set hatch 3,1
set isosamples 5
splot [-2:2][-2:2] x*x-y*y, x>1?NaN:x
