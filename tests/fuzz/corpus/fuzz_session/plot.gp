f(x,y)=sin(x)*y**2
splot [u=-1:1][0:2] f(u,y) w l t 'a' lt 3, '-' using 1:2:($3*2), x*y
0 0 1
0 1 2

1 0 3
1 1 4
e
replot rand(0)
plot sin(x), x**3 lw 2
print 1/3., 'a', f(2,3)
pause -1 'x'
