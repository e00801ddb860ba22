splot 'a' index 0:1 every 2::1 matrix
load 'b'
ÿ 1 2 3
4 5 6


7 8 9
1 2 3
ÿprint 1; load 'c'
set key
