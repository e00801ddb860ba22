#!/bin/sh
# Texts that are put together, from outside: what sprintf of gnuplot writes, names of files, titles.
. tests/cli/lib.sh

ours() {
    timeout 20 "$RIDGELINE" plot "$1" -o "${2:-none.svg}"
}

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
GPVAL_ENCODING = "utf8"
base = "d"' ]
    expect_text a.svg '<title>d is 1 of 99.5%'
    expect_text a-3.svg '<title>page 2'
    [ -e a-5.svg ] && [ ! -e a-6.svg ]
}

mistakes_are_answered() {
    expect_mistakes <<'END'
print "a".nobody@column 11: undefined variable: nobody
print "a".@column 11: a text expected
a = "x"; print sprintf("%d")@a value for each % of the format expected
print sprintf("%s", 3)@a text for %s expected
print sprintf("%q", 3)@this conversion of the format is not supported
print sprintf("%d", 3@')' expected
print sprintf(3)@a format in quotes expected
a = "x" 3@the end of the command expected
a = "x"; print a + 1@the end of the command expected
splot "no"."1"@cannot read the data file: no1
print exists(a)@the name of a variable in quotes expected
END
    awk 'BEGIN { printf "a = \x27"; for (k = 0; k < 900; k++) printf "x"; print "\x27"; for (k = 0; k < 6; k++) print "b" k " = a"; }' >a.gp
    expect_status 2 ours a.gp 2>err
    expect_text err 'no memory for this text'
    echo 'a = "0123456789"; do for [i=1:9] { a = a.a }' >a.gp
    expect_status 2 ours a.gp 2>err
    expect_text err 'too long for its buffer'
}

run_tests sprintf_writes_what_gnuplot_writes names_and_titles mistakes_are_answered
