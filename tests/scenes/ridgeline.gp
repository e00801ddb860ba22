# Profiles by the horizon algorithm (Greenspun and Little 1988): each line hides what lies behind it.
set title "ridgeline"
set paper 210,240 margin 15
set xrange [-3:3]
set yrange [0:10]
set isosamples 80
set samples 300
set view 33,0,1.8,0.34
set hidden3d horizon

# A number in [0,1] for every n, and from it eight peaks whose place, height and width differ from row to row.
u(n) = sin(91.7*n + 5.3*n**2)**2
peak(x,y,k) = (0.2 + 0.8*u(7*y+k))**2 \
    * exp(-((x - 1.5*(u(3*y+5*k) + u(5*y+11*k) - 1)) / (0.06 + 0.1*u(11*y+3*k)))**2)
peaks(x,y) = peak(x,y,1) + peak(x,y,2) + peak(x,y,3) + peak(x,y,4) \
    + peak(x,y,5) + peak(x,y,6) + peak(x,y,7) + peak(x,y,8)
window(x) = 1/(1 + exp(8*(abs(x) - 1.15)))
grain(x,y) = 0.03*(sin(23*x + 31*y) + sin(43*x - 53*y) + sin(71*x + 17*y*y))
splot window(x)*peaks(x,y) + grain(x,y)*(0.3 + 1.7*window(x))
