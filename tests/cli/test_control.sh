#!/bin/sh
# if, else, do and while, from outside: what gnuplot prints, and errors in the middle of blocks.
. tests/cli/lib.sh

blocks_do_what_gnuplot_does() {
    cat >a.gp <<'END'
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
if (0) { print 1 }
else { print "else on its line" }
if (1) { print "yes" } # remark

else { print 2 }
if (0) { print 1 }; print "between"; else { print "later" }
do for [i=1:2] {
  if (i == 1) {
    print "A"
  }
  else {
    print "B"
  }
}
if (1) { if (0) { print 1 }
else { print "inner" } }
else { print "outer" }
if (1)
{
  print "brace on its line"
}
if (0) print 1; print 2; else print 3; print 4
if (1) print 1; else print 2; do for [i=1:2] {
  print i
}
if (0) print 1; do for [i=1:2] {
  print i
}; print 4; else print 6
do for [i=1:3] for [j=i:2] { print i, j }
do for [w in "a b"] for [j=1:2] { do for [k=1:1] for [l=1:2] { if (l == 2 && w eq "a") { break }; print w, j, k, l } }
do for [i=1:3] for [j=1:2] { if (i == 2) { break }; if (j == 1) { continue }; print i, j }
END
    ours a.gp >ours.txt 2>&1
    [ "$(wc -l <ours.txt)" = 59 ]
    command -v gnuplot >/dev/null || return 0
    gnuplot a.gp >theirs.txt 2>&1
    diff theirs.txt ours.txt
    echo "# $(wc -l <ours.txt) lines printed from blocks equal gnuplot's"
}

alternatives_may_follow_each_other() { # gnuplot 5.4 wants `else { if`
    printf 'do for [a=1:4] {\n  if (a == 1) {\n    print "one"\n  } else if (a == 2) {\n    print "two"\n  } else if (a == 3) { print "three" } else {\n    print "many"\n  }\n}\n' >a.gp
    [ "$(ours a.gp | tr '\n' ' ')" = 'one two three many ' ]
    printf 'do for [a=1:3] {\nif (a == 1)\n{\nprint "one"\n}\nelse if (a == 2)\n{\nprint "two"\n}\nelse\n{\nprint "many"\n}\n}\n' >a.gp
    [ "$(ours a.gp | tr '\n' ' ')" = 'one two many ' ]
    # a condition without braces reaches to the end of its physical line
    printf 'do for [a=1:2] {\n  if (a == 1) print "first"; else print "other"\n  if (a == 2) print "x"; print "y"\n  print "end"\n}\n' >a.gp
    [ "$(ours a.gp | tr '\n' ' ')" = 'first end other x y end ' ]
}

every_plot_in_a_loop_is_a_page() {
    printf 'do for [i=1:3] {\n  set view 60,20*i\n  splot sin(i*x)*cos(y)\n}\ndo for [i=1:2] {\nsplot "-" using (i*$1)\n1\n2\n\n3\n4\ne\n}\n' >a.gp
    expect_status 2 ours a.gp 2>err # rows do not belong into a block
    printf 'do for [i=1:3] {\n  set view 60,20*i\n  splot sin(i*x)*cos(y)\n}\n' >b.gp
    timeout 20 "$RIDGELINE" plot b.gp -o b.seg
    [ -e b.seg ] && [ -e b-3.seg ] && [ ! -e b-4.seg ]
    for i in 1 2 3; do
        echo "set view 60,20*$i; splot sin($i*x)*cos(y)" | timeout 20 "$RIDGELINE" plot - -o c.seg
        if [ $i = 1 ]; then cmp b.seg c.seg; else cmp b-$i.seg c.seg; fi
    done
}

errors_name_the_line_of_the_block() {
    expect_mistakes <<'MISTAKES'
else { print 1 }@column 1: there is no `if` to this `else`
if (1) { print 1 } print 2@column 20: the end of the command expected
do for [i=1:2] { print i } print 2@column 28: the end of the command expected
{ print 1 }@column 1: a block stands behind if, else, do or while only
MISTAKES
    printf 'a = 1\ndo for [i=1:2] {\n  print i # fine\n  print 1 +\n}\n' >a.gp
    expect_status 2 ours a.gp 2>err
    expect_text err '"a.gp", line 4, column 12: a value expected'
    expect_text err '  print 1 +'
    printf 'do for [i=1:2] {\n  $d << END\n1 2\nEND\n}\nprint 3\n' >a.gp
    expect_status 2 ours a.gp >out 2>err
    expect_text err '"a.gp", line 2, column 3: a data block cannot begin within { }'
    printf 'if (1) {\n  print 2\n' >a.gp
    expect_status 2 ours a.gp 2>err
    expect_text err 'a { is not closed'
    printf 'load "a.gp"\n' >b.gp
    expect_status 2 ours b.gp 2>err
    expect_text err 'a { is not closed'
    expect_mistakes <<'END'
break@this stands in no loop
if (1) { break }@this stands in no loop
}@no block is open
if 3 {}@a condition in brackets
do {}@`for` expected
do for [i=1:2:0] {}@the step is 0
do for [3:2] {}@[i=first:last] expected
do for [i=1] {}@expected
while (1) print 1@'{' expected
while (1) {}@goes round too often
if (nobody) {}@undefined variable: nobody
do for [i=1:2] print i@'{' expected
if (1) { if (1) { if (1) { if (1) { if (1) { if (1) { if (1) { if (1) { if (1) { print 1 } } } } } } } } }@blocks within blocks
END
}

elements_for_each_value() {
    draw() { printf 'set isosamples 9; f(x) = a*x; g(x) = f(x) + b\n%s\n' "$1" | timeout 20 "$RIDGELINE" plot - -o "$2"; }
    draw 'splot for [a=1:3] a*x+4*y+a*x*y' one.seg
    draw 'splot x+4*y+x*y, 2*x+4*y+2*x*y, 3*x+4*y+3*x*y' two.seg
    cmp one.seg two.seg
    # functions that look at the variable, two variables, downwards; the variables are what they were
    draw 'a = 7; splot for [a=3:1:-2] for [b=0:1] g(x)+y, 7*y; print a' one.seg >printed
    draw 'p(x,y) = x; splot 3*x+y, 3*x+1+y, x+y, x+1+y, 7*y' two.seg
    cmp one.seg two.seg
    [ "$(cat printed)" = 7 ]
    printf '0 0 1\n0 1 2\n\n1 0 3\n1 1 5\n' >d
    printf 'f(z) = k*z; splot for [k=1:3] "d" using 1:2:(f($3)+k)\n' | timeout 20 "$RIDGELINE" plot - -o one.seg
    printf 'splot "d" using 1:2:($3+1), "d" using 1:2:(2*$3+2), "d" using 1:2:(3*$3+3)\n' | timeout 20 "$RIDGELINE" plot - -o two.seg
    cmp one.seg two.seg
    echo 'f(x) = a*x; a = 7; splot for [a=1:3] f(x)+y, f(y)' >a.gp
    expect_status 2 ours a.gp 2>err
    expect_text err 'column 46: this uses a variable that `for` changes elsewhere'
    echo 'splot for [i=1:99] i*x' >a.gp
    expect_status 2 ours a.gp 2>err
    expect_text err 'too much for one plot; most elements (32)'
}

run_tests elements_for_each_value blocks_do_what_gnuplot_does alternatives_may_follow_each_other every_plot_in_a_loop_is_a_page errors_name_the_line_of_the_block
