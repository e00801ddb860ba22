/* help_texts.h - what `help` says, one text for each topic. A board's are about what it can do: it has no files.
 *
 * On a board they lie in flash, packed by firmware/tools/pack_texts.c, which includes this, too. */
#ifndef HELP_TEXTS_H
#define HELP_TEXTS_H

#include "config.h"

#define FILES (CONFIG_LOAD_DEPTH > 0)
#define SEVERAL (CONFIG_PLOT_ITEMS > 1)

static const struct {
    const char *pattern; /* as a command or an option is abbreviated */
    const char *text;
} topics[] = {
    {"", /* of all */
#if FILES
     "splot f(x,y)       draw a surface; also a data file: splot 'hill.dat', or several: splot f(x,y), 'hill.dat'\n"
#else
     "splot f(x,y)       draw a surface; splot '-': of rows that are typed next (help data)\n"
#endif
     "plot f(x)          draw a curve\n"
     "replot             draw the last plot again with the present settings\n"
     "set/unset/show     xrange yrange zrange samples isosamples view hidden3d halo xyplane paper machine dummy\n"
#if CONFIG_AREA
     "                   hatch light shadow pen crease title datafile; show all\n"
#else
     "                   title datafile; show all\n"
#endif
     "a = 3              set a variable;  f(x,y) = x*y  define a function\n"
     "print a, f(1,2)    compute\n"
#if FILES
     "load 'file'  pause -1 'text'  reset  quit  help [word]\n"
#else
     "pause -1 'text'  reset  help [word]\n"
#endif
     "Commands may be separated by ;  continued by \\ at the end of a line; # begins a comment.\n"
     "More: help splot, help set view, help functions, help data, help machine, help board, ...\n"},
    {"sp$lot",
#if SEVERAL
     "splot [x0:x1] [y0:y1] [z0:z1] ELEMENT, ELEMENT, ...     short: sp\n"
#else
     "splot [x0:x1] [y0:y1] [z0:z1] ELEMENT     short: sp\n"
#endif
#if FILES
     "ELEMENT: an expression in x and y, or 'file', or '-' (rows follow, up to a line e); then\n"
#else
     "ELEMENT: an expression in x and y, or '-' (rows follow, up to a line e); then\n"
#endif
     "  with lines (w l), title 'text', notitle, and for data: using, index, every, skip, matrix (help data).\n"
     "A range may name its variable: splot [u=0:1] [v=0:1] u*v. The grid is set isosamples.\n"},
    {"p$lot",
#if SEVERAL
     "plot [x0:x1] [y0:y1] ELEMENT, ELEMENT, ...     short: p\n"
#else
     "plot [x0:x1] [y0:y1] ELEMENT     short: p\n"
#endif
#if FILES
     "ELEMENT: an expression in x, drawn with as many points as set samples, or 'file' or '-' with rows x y or y,\n"
#else
     "ELEMENT: an expression in x, drawn with as many points as set samples, or '-' with rows x y or y,\n"
#endif
     "using 1:2, index, every; then with lines, title 'text', notitle.\n"},
#if SEVERAL
    {"rep$lot", "replot [more elements]     short: rep\nThe last plot again, with its inline data.\n"},
#else
    {"rep$lot", "replot     short: rep\nThe last plot again, with its inline data.\n"},
#endif
    {"se$t",
     "set OPTION ...     short: se\nOptions: xrange yrange zrange samples isosamples view hidden3d title "
     "xyplane paper\n"
#if CONFIG_AREA
     "halo hatch light shadow pen crease parametric polar urange vrange trange mapping logscale dgrid3d\n"
#endif
     "machine dummy datafile autoscale angles. gnuplot's other options are ignored with a warning. unset OPTION goes\n"
     "back to the default, show OPTION tells the value.\n"},
    {"uns$et", "unset OPTION: back to its default; unset hidden3d draws every line.\n"},
    {"sh$ow", "show OPTION, show all, show variables, show functions, show plot\n"},
    {"res$et", "reset: all options to their defaults. Variables and functions stay; reset session forgets them too.\n"},
    {"pr$int", "print VALUE, 'text', ...: one line.\n"
#if FILES
               "set print $name: what is printed goes into this data block. unset print\n"
#endif
    },
#if FILES
    {"l$oad", "load 'file': execute its lines.\n"},
#else
    {"l$oad", "See help board.\n"},
    {"sa$ve", "See help board.\n"},
#endif
    {"pa$use", "pause SECONDS ['text'];  pause -1 waits for Return, where there is somebody to press it.\n"},
#if CONFIG_CONTROL
    {"und$efine", "undefine a b* f(): these variables, those that begin so, this function are forgotten.\n"},
#endif
#if FILES
    {"q$uit", "quit, exit, q: the end.\n"},
    {"ex$it", "quit, exit, q: the end.\n"},
#endif
    {"vi$ew",
     "set view RX,RZ,SCALE,ZSCALE          gnuplot's rotation in degrees: 60,30,1,1. Parts may be left out: ,,,0.7\n"
     "set view from X,Y,Z [to X,Y,Z]       perspective from a point in the coordinates of the data; without `to` the\n"
     "                                     middle of the plot is looked at\n"},
    {"hid$den3d",
     "set hidden3d [perimeter]             hidden lines removed, the default\n"
     "set hidden3d [convex] [dashed]       solids; dashed: hidden parts are drawn with dashes\n"
#if CONFIG_AREA
     "set hidden3d area [outline]          solids with tones (help hatch); outline: silhouettes only (help crease)\n"
     "set hidden3d [convex] [...] seams    with the lines in which solids cut through each other\n"
#endif
     "set hidden3d horizon [infinite]      profiles across the view (a ridgeline drawing); infinite: one side only\n"
     "set hidden3d halo                    every line is drawn, with a gap where it passes behind another: help halo\n"
     "unset hidden3d                       every line is drawn\n"},
#if CONFIG_AREA
    {"hatch",
     "set hatch ANGLE,PITCH: surfaces, and solids of set hidden3d area, are hatched by the light they get, lines "
     "PITCH\n"
     "mm (1) apart at ANGLE degrees, crosswise where there is none. unset hatch: lines only. See light, shadow.\n"},
    {"pen",
     "set pen N; set pen [silhouette N] [crease N] [hidden N] [hatch N] [shadow N] [detail N]: which pen, 1 to 8,\n"
     "draws what; crease: all edges that are no silhouettes, and grids. Each pen is taken once; a plotter with one\n"
     "holder goes home and waits for the next pen, and for ~.\n"},
    {"crease",
     "set crease A: edges of solids between faces that meet at less than A degrees only where they are outlines.\n"
     "See set hidden3d ... outline.\n"},
    {"light", "set light [N] X,Y,Z: the direction to light N, 1 to 4, in the units of the data (1 -1,-2,3).\n"
              "set light [N] from X,Y,Z: a lamp at a place. unset light [N]. See hatch, shadow.\n"},
    {"shadow", "set shadow [on|off|outline]: solids cast shadows, which set hatch shows; outline: with borders.\n"},
#endif
    {"halo",
     "set halo W [ends]: with set hidden3d halo, a line is interrupted for W mm to either side of a nearer one (0.5).\n"
     "ends: also where it only comes that close to a nearer line, beside it or beyond its end. 0 is no halo.\n"},
#if CONFIG_LOGSCALE
    {"log$scale", "set logscale [xyz] [BASE]: these axes, or all, are logarithmic. unset logscale [xyz]\n"},
#endif
#if CONFIG_SCATTERED
    {"dg$rid3d",
     "set dgrid3d [ROWS[,COLUMNS]] [qnorm Q | gauss|exp|cauchy|box|hann [kdensity2d] [SX[,SY]]]: scattered points of\n"
     "data become a grid, whose heights are means of theirs weighted by their distance (10,10 qnorm 1).\n"},
#endif
#if CONFIG_SAMPLED
    {"sample",
     "plot sample [0:5] f(x), [t=5:9:0.5] '+' using (t):(f(t)): elements over ranges of their own; '+' is a file\n"
     "whose rows count through one, with a step or as set samples says; splot '++' using 1:2:3, over two.\n"},
    {"pol$ar", "set polar; plot R: a radius over the angle t; files hold angle and radius. See trange.\n"},
    {"tr$ange", "set trange [FROM:TO]: of t in plot '+', set parametric (-5:5) and set polar (0:2*pi)\n"},
    {"map$ping",
     "set mapping cartesian|cylindrical|spherical: data are x y z; angle, z, radius; or longitude, latitude,\n"
     "radius. Radius 1 may be missing. See angles.\n"},
#endif
#if CONFIG_PARAMETRIC
    {"pa$rametric",
     "set parametric; splot X, Y, Z: three expressions of u and v over urange and vrange; plot X, Y: two of t\n"},
#endif
    {"xr$ange", "set xrange [FROM:TO]   [*:5] leaves an end to the data, [5:-5] turns the axis round\n"},
    {"yr$ange", "set yrange [FROM:TO]   see help xrange\n"},
    {"zr$ange", "set zrange [FROM:TO]   heights outside of it are not drawn; see help xrange\n"},
    {"sa$mples", "set samples NX[,NY]: points of a curve, or along the lines of a surface when nothing is hidden.\n"},
    {"is$osamples", "set isosamples NX[,NY]: columns and rows of the grid that splot computes; 10,10.\n"},
    {"tit$le", "set title 'text'\n"},
    {"xyp$lane", "set xyplane at Z, or set xyplane F: the base plane F times the height of the box below it (0.5).\n"},
    {"ticsl$evel", "set ticslevel F: as set xyplane F.\n"},
    {"pap$er",
     "set paper a3|a4|a5|letter|W,H [portrait|landscape] [margin M]     millimetres; a4 landscape margin 10\n"},
    {"mach$ine",
     "set machine [steps A[,B]] [speed V] [travel V] [accel A] [junction D] [lift S] [lower S] [enable S]\n"
     "            [pulse US] [setup US] [swap|noswap] [corexy|cartesian] [size W,H|none]\n"
     "            [limits on|homing|off] [home left|right|bottom|top,..] [pulloff D] [invert LIST|none]\n"
#if CONFIG_PEN_SERVO
     "            [pen level | pen servo [UP,DOWN[,S]] | pen solenoid [S[,HOLD]]]\n"
#else
     "            [pen level | pen solenoid [S[,HOLD]]]\n"
#endif
     "steps per mm of both motors; mm/s with the pen down (speed) and up (travel); mm/s^2; junction: mm a corner may\n"
     "be cut by for speed; seconds to lift and lower the pen; pulse width and DIR set-up in microseconds.\n"
     "invert: directions x y xy, levels of step enable pen limits estop start.\n"
#if CONFIG_PEN_SERVO
     "servo: pulse widths in us, s for the way.\n"
#endif
     "solenoid: s of full power, then percent. Limits stop the machine, serve homing only, or are off.\n"},
    {"du$mmy", "set dummy U,V: the variables of expressions in plots are called U and V.\n"},
    {"dataf$ile", "set datafile separator whitespace|comma|tab|'c'. At first both blanks and commas separate.\n"},
#if FILES
    {"an$gles", "set angles degrees|radians: what sin, asin and the like take and give from then on.\n"},
#endif
    {"au$toscale", "set autoscale [x|y|z|xy...]: these ranges follow the data again.\n"},
    {"data",
#if FILES
     "splot 'file' [matrix | nonuniform matrix] [index M[:N]] [every A:B:C:D:E:F] [skip N] [using 1:2:3]\n"
#else
     "splot '-' [matrix | nonuniform matrix] [index M[:N]] [every A:B:C:D:E:F] [skip N] [using 1:2:3]\n"
#endif
     "Rows x y z, isolines separated by a blank line, data sets by two; or rows of one z: x and y are then counted\n"
#if CONFIG_PARAMETRIC
     "from 0. NaN and ? are holes; # begins a comment. Points on no grid of x and y lines: facets where all isolines\n"
     "have as many points, else lines. using 1:2:($3*2) computes from columns; using 1 takes one column of heights.\n"
#else
     "from 0. Points must lie on a grid of x and y lines, spaced as they like. NaN and ? are holes; # begins a\n"
     "comment. using 1:2:($3*2) computes from columns; using 1 takes one column of heights.\n"
#endif
#if CONFIG_BINARY
     "binary: a matrix of floats with x in its first row and y in its first column, behind their number; binary\n"
     "array=(nx,ny): x, y counted; record=(nx,ny): among the columns; format='%float%*short%2double' endian=big "
     "skip=N\n"
     "dx=D dy=D origin=(x,y,z) center=(x,y,z) flipx flipy transpose.\n"
#endif
#if FILES
     "help solids: OBJ files.\n"
#else
     "For solids see help solids.\n"
#endif
    },
    {"sol$ids",
#if FILES
     "splot 'a.obj' [translate X,Y,Z] [rotate X,Y,Z] [scale S] [crease A], 'b.obj' ...\n"
     "splot '-' solid     rows of OBJ text up to a line e: v x y z, f a b c ..., l a b, o name\n"
#else
     "splot '-' solid [translate X,Y,Z] [rotate X,Y,Z] [scale S] [crease A]\n"
     "Rows of OBJ text follow, up to a line e: v x y z, f a b c ..., l a b, o name\n"
#endif
     "Moved in the order of the words; degrees about x, then y, then z. crease: edges between faces that meet at less\n"
     "than A degrees only where they are outlines. With set hidden3d horizon they are a terrain.\n"
#if CONFIG_AREA
     "translucent ['NAME' ...]: with set hidden3d area what is behind is drawn too, with dashes; NAME: only faces\n"
     "behind usemtl NAME, g NAME or o NAME.\n"
     "f a b c h d e f: with a hole.  d a b ...: lines on the face before; d a b c [h d e f] tone P: a polygon on it\n"
     "that gives back P percent of the light (help hatch)\n"
#endif
    },
#if CONFIG_CONTROL
    {"te$xts",
     "file = 'a.dat'    splot file title \"n = \".n    set title sprintf(\"%03d, %g\", i, x)    exists(\"file\")\n"
     "a . b joins texts and numbers, a eq b and a ne b compare texts, a[2:5] is a part of one; strlen, strstrt,\n"
     "substr, word, words, sprintf are functions of them; what is a number counts as one: '3' + 4.\n"},
    {"array", "array A[5]    array A = [1, 'two', 3.5]    A[2] = x    A[i] + |A|    print A\n"},
    {"loops", "do for [i=1:9:2] {...}    while (c) {...}    break    continue    if (c) {...} else {...}\n"
              "do for [w in 'one two three'] {...}    do for [i=1:3] for [j=1:i] {...}\n"
              "splot for [i=1:3] i*x*y: one element for each value of i; [i=0:*]: as long as index i has data.\n"
              "Blocks may go over many lines.\n"},
#if FILES
    {"eval$uate", "evaluate TEXT: executes it.\n"},
#endif
#endif
    {"fu$nctions",
     "abs acos asin atan atan2 besj0 besj1 ceil cos cosh erf exp floor gamma int invnorm log log10 max min norm\n"
     "rand real sgn sin sinh sqrt tan tanh; operators ** ! - + * / % << >> < <= > >= == != & ^ | && || ?:\n"
     "Integers divide as integers: 7/2 is 3, 7./2 is 3.5. What has no value (1/0, sqrt(-1)) is a hole.\n"
     "rand(0) in a plot depends on the place only: the same picture comes out every time.\n"},
    {"board",
#if FILES
     "Of a board's console:\n"
#endif
     "home               to the limit switches, which makes the place of the pen known\n"
     "unlock             the pen was put to its origin by hand\n"
     "pen up|down  motors on|off\n"
     "save  load         the present scene, kept without power; the start button draws it\n"
     "autorun on|off     draw it when the power comes on\n"
     "status  memory     as ?; how much of each memory was used\n"
     "At any time, first on a line:  ? status  ! hold  ~ resume  Ctrl-X stop\n"},
};

#endif
