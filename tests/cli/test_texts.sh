#!/bin/sh
# Texts that are put together, from outside: what sprintf of gnuplot writes, names of files, titles.
. tests/cli/lib.sh

# Two thousand conversions; reals have at most 16 digits before and behind the point, since we have 17.
sprintf_writes_what_gnuplot_writes() {
    awk 'BEGIN {
        srand(7)
        split("- + 0 -+ +0", flags, " "); flags[6] = " "; split("5 12 1 30", width, " "); split(".0 .1 .3 .8", precision, " ")
        split("d i x X o e E f g G f g", type, " ")
        for (k = 0; k < 2000; k++) {
            t = type[1 + int(rand() * 12)]
            f = "%" (rand() < .5 ? flags[1 + int(rand() * 6)] : "") (rand() < .5 ? width[1 + int(rand() * 4)] : "") (rand() < .6 ? precision[1 + int(rand() * 4)] : "") t
            if (t ~ /[di]/) v = int((rand() - .5) * 2000000)
            else if (t ~ /[xXo]/) v = int(rand() * 1000000)
            else v = sprintf("%.15g", (rand() - .5) * exp(int((rand() - .5) * (t == "f" ? 30 : 60))))
            if (t ~ /[eEfgG]/ && rand() < .2) v = int(v * 8 + .5) / 8.0
            if (v !~ /[.e]/ && t ~ /[eEfgG]/) v = v ".0"
            printf "print \x27[\x27.sprintf(\"%s\", %s).\x27]\x27\n", f, v
        }
    }' >a.gp
    ours a.gp >ours.txt
    [ "$(wc -l <ours.txt)" = 2000 ]
    command -v gnuplot >/dev/null || return 0
    gnuplot a.gp 2>theirs.txt
    diff theirs.txt ours.txt
    echo "# $(wc -l <ours.txt) numbers that sprintf wrote equal gnuplot's"
}

names_and_titles() {
    printf '1 2\n3 4\n' >d1.mat
    cat >a.gp <<'END'
base = 'd'; ext = ".mat"
n = 1
set title sprintf("%s is %d of %.1f%%", base, n, 99.5)
splot base.n.ext matrix title "t".n
do for [i=1:2] { set title "page ".i; splot for [k=1:i] base."1".ext matrix using 1:2:($3+k) }
whole = base.n.ext
splot whole matrix, '' matrix using 1:2:(-$3)
replot
print whole, exists("whole"), exists("nobody"), exists("n"), "a".'b'.n
whole = 3
print whole + 1
reset session
print exists("base")
base = "d"; show variables
END
    ours a.gp a.svg >out
    [ "$(cat out)" = 'd1.mat 1 0 1 ab1
4
0
pi = 3.14159265358979
NaN = NaN
GPVAL_VERSION = 5.4
ARGC = 0
GPVAL_ENCODING = "utf8"
GPVAL_COMPILE_OPTIONS = ""
GPVAL_TERM = "unknown"
base = "d"' ]
    expect_text a.svg '<title>d is 1 of 99.5%'
    expect_text a-3.svg '<title>page 2'
    [ -e a-5.svg ] && [ ! -e a-6.svg ]
}

mistakes_are_answered() {
    expect_mistakes <<'END'
print "a".nobody@column 11: undefined variable: nobody
print "a".@column 11: a value expected
a = "x"; print sprintf("%d")@a value for each % of the format is needed
print sprintf("%s", 3)@a text for %s is needed
print sprintf("%q", 3)@a conversion of the format is not supported
print sprintf("%d", 3@')' expected
print sprintf(3)@a format in quotes is needed
a = "x" 3@the end of the command expected
a = "x"; print a + 1@column 16: this text is not a number
print !"3"@column 7: non-integer passed to boolean operator
print "3" & 1@column 7: non-integer passed to boolean operator
t = "abc"; splot (y>0?t:3)@column 18: a number is needed here, not a text
t = "abc"; splot (y>3?t:3)@column 18: some points could not be computed: a name is missing, a text is no number
t = "abc"; splot (y>3?t:x*exp(-y))@column 18: some points could not be computed: a name is missing, a text is no number
t = "abc"; plot (x>3?t:3)@column 17: some points could not be computed: a name is missing, a text is no number
set nonsense@column 5: unknown option: nonsense
unset parametric x@column 18: the end of the command expected
print sin("x")@column 7: this text is not a number
print atan2("x", 1)@column 7: this text is not a number
print strlen(3)@a text is needed here, not a number
a = 3; print a[1:2]@a text is needed here, not a number
print "abc"[2]@':' expected: no array is called so
a = "abc"; print a[1:2@']' expected
if ("a" && 1) {print 1}@non-integer passed to boolean operator
array A[3]; print A[4]@column 19: array index out of range
array A[3]; A[0] = 1@column 15: array index out of range
array A[2] = [1,2,3]@column 7: more values than the array has elements
array A = [1,2@',' or ']' expected
array A@[size], or = [value, ...] expected
array A[0]@the size of this array is out of range
array A[30000]@no memory for this array
array A[1024]; array B = []; plot B[1]@array index out of range
array t[2]; undefine t; t = "1"; splot t[1:1]@cannot read the data file: 1
B[1] = 3@column 1: unknown array: B
array A[1]; undefine A; print |A|@column 32: the name of an array expected
do for [w in 3] {print w}@a text with words expected
evaluate 3@a text in quotes expected
evaluate "foo 1"@"$ evaluated", line 1, column 1: unknown command: foo
plot x title f(3)@column 14: undefined function: f
f(x) = x; set title f(3)@column 21: a text in quotes expected
a = "q"; plot a*x@this text is not a number
splot strcol(1)@texts in columns of data are not kept
splot "no"."1"@cannot read the data file: no1
print exists(a)@the name of a variable in quotes expected
END
    awk 'BEGIN { printf "a = \x27"; for (k = 0; k < 900; k++) printf "x"; print "\x27"; for (k = 0; k < 6; k++) print "b" k " = a"; }' >a.gp
    expect_status 2 ours a.gp 2>err
    expect_text err 'no memory for this text'
    echo 'a = "0123456789"; do for [i=1:9] { a = a.a }' >a.gp
    expect_status 2 ours a.gp 2>err
    expect_text err 'no memory for this text'
}

# Lines of texts, arrays and loops over words; gnuplot counts bytes where no encoding was set.
texts_and_arrays_do_what_gnuplots_do() {
    cat >a.gp <<'END'
set encoding utf8
a = "hello"; n = 4; w = "the quick  brown fox"
print a[2:3], a[2:*], a[:2], a[0:9], "|".a[4:2]."|", a[5:5]
print a eq "hello", a ne "hello", "a"."b" eq "ab" ? "yes" : "no"
print strlen(a), strlen(""), strlen("größer"), "größer"[3:4], strstrt(a, "ll"), strstrt(a, "x"), strstrt("", ""), sprintf("%x", -6442449715), sprintf("%x", -7)
print words(w), word(w, 2), "|".word(w, 9)."|", words(""), substr(a, 2, 4)
print "3" + 4, "3.5" * 2, -"2", sin("1"), int("0x10"), int("7.9"), real("2")
print atan2("1", "2"), sgn("-3"), rand("0") > 0, ceil("2.1")
f(x) = x . "!"; g(n) = n == 0 ? "none" : n == 1 ? "one" : "many ".n
print f("hey"), g(0), g(1), g(n), f(g(7)), strlen(f(g(7)))
t(x) = sprintf("%s has %d", x, strlen(x))
print t(a), t(t(a))
b = c = "both"; print b, c, (b = "other", b), c
if (a eq "hello" && n == 4) { print "conditions" } else { print "none" }
array A[4] = [1, "two", 3.5]
print A; print |A|, A[2], A[1] + A[3]
A[4] = A[1] + 10; A[1] = "one"; print A
array B = [7, 8]; array A[2]; A[1] = B[2]; print A[1], |A|; print B
h(k) = B[k] * 2; print h(1) + h(2)
do for [x in w] { print "word ".x }
do for [k=1:|B|] { print sprintf("B[%d] is %d", k, B[k]) }
do for [x in "1 2 3"] { if (x eq "2") { continue }; print x + 1 }
x = 5; do for [x in "in"] { print x }; print x
array T = ["a b", "d", "c"]
do for [i=1:3] { do for [j in T[i]] { print "".i.": ".j } }
eval "q = 6; print q*7"
eval sprintf("r%d = %d", 3, 33); print r3
set print $kept
print "1 2"; print 3, 4
set print
load "more.gp"
set print $rows; do for [i=1:3] { print sprintf("%d %d", i, i*i) }; unset print
undefine A B; print exists("A"), exists("B"), exists("a"), exists("nobody")
n = "text"; print n; n = 3; print n + 1
END
    echo 'print |T|, T[1]' >more.gp
    ours a.gp >ours.txt
    [ "$(wc -l <ours.txt)" = 36 ]
    command -v gnuplot >/dev/null || return 0
    gnuplot a.gp 2>theirs.txt
    sed 's/  */ /g; s/ $//; /^$/d' theirs.txt >theirs # an array is printed with two line ends
    sed 's/  */ /g; s/ $//' ours.txt >ours
    diff theirs ours
    echo "# $(wc -l <ours.txt) lines of texts and arrays equal gnuplot's"
}

data_come_from_texts() {
    cat >a.gp <<'END'
set print $d
do for [i=0:3] { do for [j=0:3] { print sprintf("%d %d %d", i, j, i*j) }; print "" }
unset print
col = 3
splot $d using 1:2:col with lines
splot $d using 1:2:(strlen("abc") + $3):("label") title "a"."b"
array S[3] = [1, 2, 3]
splot for [k=1:3] $d using 1:2:(S[k] * 9 + $3)
END
    ours a.gp a.seg
    [ "$(wc -l <a-3.seg)" -gt "$(wc -l <a.seg)" ]
    echo 'undefine $*; splot $d' >>a.gp
    expect_status 2 ours a.gp 2>err
    expect_text err 'cannot read the data file: $d'
    printf '0 0 1\n0 1 2\n\n1 0 3\n1 1 4\n\n\n0 0 5\n0 1 6\n\n1 0 7\n1 1 8\n' >two.dat
    echo 'splot for [i=0:*] "two.dat" index i title "set ".i; replot' | ridgeline plot - -o open.seg
    echo 'splot "two.dat" index 0, "" index 1; replot' | ridgeline plot - -o set.seg
    cmp open.seg set.seg
    cmp open-2.seg set.seg
    echo 'array A[2] = [1, "two.dat"]; splot A[2] index 0, "" index 1' | ridgeline plot - -o open.seg
    cmp open.seg set.seg
    echo 'c = "3 4"; t = "2"; plot word(c, 1)*x + word(c, 2) title "", t + x title ""' | ridgeline plot - -o text.seg
    echo 'plot 3*x + 4 title "", 2 + x title ""' | ridgeline plot - -o number.seg
    cmp text.seg number.seg
    echo 'splot for [i=2:*] "two.dat" index i' | expect_status 2 ridgeline plot - 2>err
    expect_text err 'no data'
}

run_tests sprintf_writes_what_gnuplot_writes names_and_titles mistakes_are_answered \
    texts_and_arrays_do_what_gnuplots_do data_come_from_texts
