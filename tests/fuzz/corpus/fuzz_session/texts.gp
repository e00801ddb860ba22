f = "a"; n = 3
set title sprintf("%5.2f %s %d", 2.5, f, n)." x".n
splot for [i=1:2] '-' using 1:(i*$2):3 title f.i
0 0 1
1 1 2

2 0 1
2 1 3
e
0 0 1
e
print exists("f"), f.n
do for [i=1:2] { splot for [j=1:i] x*j title "t".j }
