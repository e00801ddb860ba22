a = 3
if (a == 3) print "three"; else print "other"
if (a == 4) print "four"; print "no"; else print "else"
if (a > 5) {
   print "big" # comment }
} else {
   print "middle"
   if (a == 3) { print "in" } else { print "never" }
}
do for [i=1:3] {
  do for [j=1:i] { print i, j }
  if (i == 2) { continue }
  print "end", i
}
while (a > 0) {
  a = a - 1
  if (a == 1) { break }
  print a
}
do for [k = 5:1:-2] { if (k==3) { continue }; print "k", k }
do for [k = 3:1] { print "never" }
if (0) { print "x" } else { if (1) { print "deep" } }
if (1) print 1; if (0) print 2; else print 3
if (1) { print "one" ; print "two" }
if (0.5) { print "real" }
n = 0
while (1) { n = n + 1; if (n > 5) { break } ; do for [m=1:9] { if (m > 2) { break } ; print n, m } }
if (a == 1) {
  f(x) = x > 0 ? x : -x
  print f(-3); b = f(2) ** 3 ; print b
}
do for [i=1:2] { if (i == 1) { print "a" } else { print "b" }; print "c" }
