# A sinc seen orthographically: gnuplot's own projection.
set title "sinc(r), 60x60, orthographic"
set xrange [-12:12]
set yrange [-12:12]
set isosamples 60
set view 60,30
sinc(r) = sin(r)/r
splot sinc(sqrt(x**2 + y**2))
