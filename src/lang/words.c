/* words.c - gnuplot 5.4's words in its own order (set.c, command.c, tables.c), so that abbreviations mean the same. */
#include "lang/words.h"

#include "config.h"

bool words_match(const char *pattern, const char *text, size_t len) {
    size_t i = 0;
    bool enough = false;
    for (; *pattern; pattern++) {
        if (*pattern == '$') {
            enough = true;
        } else if (i == len) {
            return enough;
        } else if (text[i++] != *pattern) {
            return false;
        }
    }
    return i == len;
}

int words_find(const char *table, const lexer_t *lx) {
    if (lx->tok.kind != TOKEN_NAME) return -1;
    for (int i = 0; *table; i++, table += strlen(table) + 1)
        if (words_match(table, lexer_text(lx), lx->tok.len)) return i;
    return -1;
}

#if CONFIG_CONTROL
#define CONTROL CMD_CONTROL
#define UNDEFINE CMD_UNDEFINE
#define ARRAY CMD_ARRAY
#define EVALUATE (CONFIG_LOAD_DEPTH ? CMD_EVALUATE : CMD_UNSUPPORTED)
#else
#define CONTROL CMD_UNSUPPORTED
#define UNDEFINE CMD_IGNORED
#define ARRAY CMD_UNSUPPORTED
#define EVALUATE CMD_UNSUPPORTED
#endif
#define COMMANDS(WORD)                                                                                                 \
    WORD("array", ARRAY)                                                                                               \
    WORD("bi$nd", CMD_IGNORED)                                                                                         \
    WORD("break", CONTROL)                                                                                             \
    WORD("ca$ll", CMD_UNSUPPORTED)                                                                                     \
    WORD("cd", CMD_UNSUPPORTED)                                                                                        \
    WORD("cl$ear", CMD_IGNORED)                                                                                        \
    WORD("continue", CONTROL)                                                                                          \
    WORD("do", CONTROL)                                                                                                \
    WORD("eval$uate", EVALUATE)                                                                                        \
    WORD("ex$it", CMD_EXIT)                                                                                            \
    WORD("f$it", CMD_UNSUPPORTED)                                                                                      \
    WORD("h$elp", CMD_HELP)                                                                                            \
    WORD("hi$story", CMD_IGNORED)                                                                                      \
    WORD("if", CONTROL)                                                                                                \
    WORD("import", CMD_UNSUPPORTED)                                                                                    \
    WORD("else", CONTROL)                                                                                              \
    WORD("l$oad", CMD_LOAD)                                                                                            \
    WORD("low$er", CMD_IGNORED)                                                                                        \
    WORD("pa$use", CMD_PAUSE)                                                                                          \
    WORD("p$lot", CMD_PLOT)                                                                                            \
    WORD("pr$int", CMD_PRINT)                                                                                          \
    WORD("printerr$or", CMD_PRINT)                                                                                     \
    WORD("pwd", CMD_IGNORED)                                                                                           \
    WORD("q$uit", CMD_EXIT)                                                                                            \
    WORD("ra$ise", CMD_IGNORED)                                                                                        \
    WORD("ref$resh", CMD_REPLOT)                                                                                       \
    WORD("rep$lot", CMD_REPLOT)                                                                                        \
    WORD("re$read", CMD_UNSUPPORTED)                                                                                   \
    WORD("res$et", CMD_RESET)                                                                                          \
    WORD("sa$ve", CMD_UNSUPPORTED)                                                                                     \
    WORD("scr$eendump", CMD_IGNORED)                                                                                   \
    WORD("se$t", CMD_SET)                                                                                              \
    WORD("she$ll", CMD_UNSUPPORTED)                                                                                    \
    WORD("sh$ow", CMD_SHOW)                                                                                            \
    WORD("sp$lot", CMD_SPLOT)                                                                                          \
    WORD("st$ats", CMD_UNSUPPORTED)                                                                                    \
    WORD("sy$stem", CMD_UNSUPPORTED)                                                                                   \
    WORD("test", CMD_IGNORED)                                                                                          \
    WORD("tog$gle", CMD_IGNORED)                                                                                       \
    WORD("und$efine", UNDEFINE)                                                                                        \
    WORD("uns$et", CMD_UNSET)                                                                                          \
    WORD("up$date", CMD_IGNORED)                                                                                       \
    WORD("vclear", CMD_UNSUPPORTED)                                                                                    \
    WORD("vfill", CMD_UNSUPPORTED)                                                                                     \
    WORD("voxel", CMD_UNSUPPORTED)                                                                                     \
    WORD("while", CONTROL)
const char words_command[] = COMMANDS(WORDS_PATTERN);
const uint8_t words_command_id[] = {COMMANDS(WORDS_ID)};
_Static_assert(sizeof words_command_id <= WORDS_WARNED_STYLE, "a warning bit for each");

/* Full words, so their place in the table does not matter. */
#if CONFIG_AREA
#define OPTIONS_OURS(WORD)                                                                                             \
    WORD("crease", SET_CREASE)                                                                                         \
    WORD("hatch", SET_HATCH) WORD("light", SET_LIGHT) WORD("pen", SET_PEN) WORD("shadow", SET_SHADOW)
#else
#define OPTIONS_OURS(WORD)
#endif
/* What a build is without is as gnuplot's other options are. */
#define LOGSCALE (CONFIG_LOGSCALE ? SET_LOGSCALE : SET_NONLINEAR)
#define PRINT (CONFIG_LOAD_DEPTH ? SET_PRINT : SET_IGNORED)
#define PALETTE (CONFIG_LOAD_DEPTH ? SET_PALETTE : SET_IGNORED)
#define DGRID (CONFIG_SCATTERED ? SET_DGRID : SET_IGNORED)
#define MAPPING (CONFIG_SAMPLED ? SET_MAPPING : SET_IGNORED)
#define TRANGE (CONFIG_SAMPLED ? SET_TRANGE : SET_IGNORED)
#define URANGE (CONFIG_PARAMETRIC ? SET_URANGE : SET_IGNORED)
#define VRANGE (CONFIG_PARAMETRIC ? SET_VRANGE : SET_IGNORED)
#define OPTIONS(WORD)                                                                                                  \
    WORD("all", SET_ALL)                                                                                               \
    WORD("an$gles", SET_ANGLES)                                                                                        \
    WORD("ar$row", SET_IGNORED)                                                                                        \
    WORD("au$toscale", SET_AUTOSCALE)                                                                                  \
    WORD("b$ars", SET_IGNORED)                                                                                         \
    WORD("bm$argin", SET_IGNORED)                                                                                      \
    WORD("bor$der", SET_BORDER)                                                                                        \
    WORD("boxd$epth", SET_IGNORED)                                                                                     \
    WORD("box$width", SET_IGNORED)                                                                                     \
    WORD("cl$abel", SET_IGNORED)                                                                                       \
    WORD("c$lip", SET_IGNORED)                                                                                         \
    WORD("cntrp$aram", SET_IGNORED)                                                                                    \
    WORD("cntrl$abels", SET_IGNORED)                                                                                   \
    WORD("cont$ours", SET_IGNORED)                                                                                     \
    WORD("color", SET_IGNORED)                                                                                         \
    WORD("colour", SET_IGNORED)                                                                                        \
    WORD("colorb$ox", SET_IGNORED)                                                                                     \
    WORD("colorn$ames", SET_IGNORED)                                                                                   \
    WORD("colors$equence", SET_IGNORED)                                                                                \
    WORD("dasht$ype", SET_IGNORED)                                                                                     \
    WORD("data", SET_IGNORED)                                                                                          \
    WORD("dataf$ile", SET_DATAFILE)                                                                                    \
    WORD("dec$imalsign", SET_IGNORED)                                                                                  \
    WORD("dg$rid3d", DGRID)                                                                                            \
    WORD("du$mmy", SET_DUMMY)                                                                                          \
    WORD("enc$oding", SET_IGNORED)                                                                                     \
    WORD("errorb$ars", SET_IGNORED)                                                                                    \
    WORD("fit", SET_IGNORED)                                                                                           \
    WORD("font$path", SET_IGNORED)                                                                                     \
    WORD("fo$rmat", SET_IGNORED)                                                                                       \
    WORD("fu$nctions", SET_FUNCTIONS)                                                                                  \
    WORD("g$rid", SET_IGNORED)                                                                                         \
    WORD("halo", SET_HALO)                                                                                             \
    WORD("hid$den3d", SET_HIDDEN3D)                                                                                    \
    WORD("historys$ize", SET_IGNORED)                                                                                  \
    WORD("his$tory", SET_IGNORED)                                                                                      \
    WORD("is$osamples", SET_ISOSAMPLES)                                                                                \
    WORD("isosurf$ace", SET_IGNORED)                                                                                   \
    WORD("jitter", SET_IGNORED)                                                                                        \
    WORD("k$ey", SET_IGNORED)                                                                                          \
    WORD("keyt$itle", SET_IGNORED)                                                                                     \
    WORD("la$bel", SET_IGNORED)                                                                                        \
    WORD("lines$tyle", SET_IGNORED)                                                                                    \
    WORD("ls", SET_IGNORED)                                                                                            \
    WORD("linet$ype", SET_IGNORED)                                                                                     \
    WORD("lt", SET_IGNORED)                                                                                            \
    WORD("link", SET_IGNORED)                                                                                          \
    WORD("lm$argin", SET_IGNORED)                                                                                      \
    WORD("loa$dpath", SET_IGNORED)                                                                                     \
    WORD("loc$ale", SET_IGNORED)                                                                                       \
    WORD("log$scale", LOGSCALE)                                                                                        \
    WORD("mac$ros", SET_IGNORED)                                                                                       \
    WORD("mach$ine", SET_MACHINE)                                                                                      \
    WORD("map$ping3d", MAPPING)                                                                                        \
    WORD("mar$gins", SET_IGNORED)                                                                                      \
    WORD("micro", SET_IGNORED)                                                                                         \
    WORD("minus$sign", SET_IGNORED)                                                                                    \
    WORD("missing", SET_IGNORED)                                                                                       \
    WORD("mo$use", SET_IGNORED)                                                                                        \
    WORD("mono$chrome", SET_IGNORED)                                                                                   \
    WORD("multi$plot", SET_IGNORED)                                                                                    \
    WORD("mx2t$ics", SET_IGNORED)                                                                                      \
    WORD("mxt$ics", SET_IGNORED)                                                                                       \
    WORD("my2t$ics", SET_IGNORED)                                                                                      \
    WORD("myt$ics", SET_IGNORED)                                                                                       \
    WORD("mzt$ics", SET_IGNORED)                                                                                       \
    WORD("mcbt$ics", SET_IGNORED)                                                                                      \
    WORD("mrt$ics", SET_IGNORED)                                                                                       \
    WORD("mtt$ics", SET_IGNORED)                                                                                       \
    WORD("nonlin$ear", SET_NONLINEAR)                                                                                  \
    WORD("obj$ect", SET_IGNORED)                                                                                       \
    WORD("of$fsets", SET_IGNORED)                                                                                      \
    WORD("or$igin", SET_IGNORED)                                                                                       \
    WORD("o$utput", SET_IGNORED)                                                                                       \
    WORD("overflow", SET_IGNORED)                                                                                      \
    WORD("pap$er", SET_PAPER)                                                                                          \
    WORD("pa$rametric", SET_PARAMETRIC)                                                                                \
    WORD("pal$ette", PALETTE)                                                                                          \
    WORD("pax$is", SET_IGNORED)                                                                                        \
    WORD("pix$map", SET_IGNORED)                                                                                       \
    WORD("pm$3d", SET_IGNORED)                                                                                         \
    WORD("pointint$ervalbox", SET_IGNORED)                                                                             \
    WORD("poi$ntsize", SET_IGNORED)                                                                                    \
    WORD("pol$ar", SET_POLAR)                                                                                          \
    WORD("pr$int", PRINT)                                                                                              \
    WORD("psdir", SET_IGNORED)                                                                                         \
    WORD("rax$is", SET_IGNORED)                                                                                        \
    WORD("rgbmax", SET_IGNORED)                                                                                        \
    WORD("rlabel", SET_IGNORED)                                                                                        \
    WORD("rm$argin", SET_IGNORED)                                                                                      \
    WORD("rr$ange", SET_IGNORED)                                                                                       \
    WORD("rti$cs", SET_IGNORED)                                                                                        \
    WORD("sa$mples", SET_SAMPLES)                                                                                      \
    WORD("si$ze", SET_IGNORED)                                                                                         \
    WORD("spider$plot", SET_IGNORED)                                                                                   \
    WORD("st$yle", SET_STYLE)                                                                                          \
    WORD("su$rface", SET_IGNORED)                                                                                      \
    WORD("t$erminal", SET_IGNORED)                                                                                     \
    WORD("tab$le", SET_IGNORED)                                                                                        \
    WORD("termop$tions", SET_IGNORED)                                                                                  \
    WORD("theta", SET_IGNORED)                                                                                         \
    WORD("ti$cs", SET_TICS)                                                                                            \
    WORD("ticsc$ale", SET_IGNORED)                                                                                     \
    WORD("ticsl$evel", SET_TICSLEVEL)                                                                                  \
    WORD("time", SET_IGNORED)                                                                                          \
    WORD("timef$mt", SET_IGNORED)                                                                                      \
    WORD("times$tamp", SET_IGNORED)                                                                                    \
    WORD("tit$le", SET_TITLE)                                                                                          \
    WORD("tm$argin", SET_IGNORED)                                                                                      \
    WORD("tr$ange", TRANGE)                                                                                            \
    WORD("tti$cs", SET_IGNORED)                                                                                        \
    WORD("ur$ange", URANGE)                                                                                            \
    WORD("v$ariables", SET_VARIABLES)                                                                                  \
    WORD("ve$rsion", SET_VERSION)                                                                                      \
    WORD("vg$rid", SET_IGNORED)                                                                                        \
    WORD("vi$ew", SET_VIEW)                                                                                            \
    WORD("vr$ange", VRANGE)                                                                                            \
    WORD("vxr$ange", SET_IGNORED)                                                                                      \
    WORD("vyr$ange", SET_IGNORED)                                                                                      \
    WORD("vzr$ange", SET_IGNORED)                                                                                      \
    WORD("wall$s", SET_IGNORED)                                                                                        \
    WORD("xyp$lane", SET_XYPLANE)                                                                                      \
    WORD("xr$ange", SET_XRANGE)                                                                                        \
    WORD("yr$ange", SET_YRANGE)                                                                                        \
    WORD("zr$ange", SET_ZRANGE)                                                                                        \
    WORD("x2r$ange", SET_IGNORED)                                                                                      \
    WORD("y2r$ange", SET_IGNORED)                                                                                      \
    WORD("cbr$ange", SET_IGNORED)                                                                                      \
    WORD("xda$ta", SET_IGNORED)                                                                                        \
    WORD("x2da$ta", SET_IGNORED)                                                                                       \
    WORD("yda$ta", SET_IGNORED)                                                                                        \
    WORD("y2da$ta", SET_IGNORED)                                                                                       \
    WORD("zda$ta", SET_IGNORED)                                                                                        \
    WORD("cbda$ta", SET_IGNORED)                                                                                       \
    WORD("xl$abel", SET_IGNORED)                                                                                       \
    WORD("x2l$abel", SET_IGNORED)                                                                                      \
    WORD("yl$abel", SET_IGNORED)                                                                                       \
    WORD("y2l$abel", SET_IGNORED)                                                                                      \
    WORD("zl$abel", SET_IGNORED)                                                                                       \
    WORD("cbl$abel", SET_IGNORED)                                                                                      \
    WORD("xti$cs", SET_XTICS)                                                                                          \
    WORD("x2ti$cs", SET_IGNORED)                                                                                       \
    WORD("yti$cs", SET_YTICS)                                                                                          \
    WORD("y2ti$cs", SET_IGNORED)                                                                                       \
    WORD("zti$cs", SET_ZTICS)                                                                                          \
    WORD("cbti$cs", SET_IGNORED)                                                                                       \
    WORD("xdti$cs", SET_IGNORED)                                                                                       \
    WORD("x2dti$cs", SET_IGNORED)                                                                                      \
    WORD("ydti$cs", SET_IGNORED)                                                                                       \
    WORD("y2dti$cs", SET_IGNORED)                                                                                      \
    WORD("zdti$cs", SET_IGNORED)                                                                                       \
    WORD("cbdti$cs", SET_IGNORED)                                                                                      \
    WORD("xmti$cs", SET_IGNORED)                                                                                       \
    WORD("x2mti$cs", SET_IGNORED)                                                                                      \
    WORD("ymti$cs", SET_IGNORED)                                                                                       \
    WORD("y2mti$cs", SET_IGNORED)                                                                                      \
    WORD("zmti$cs", SET_IGNORED)                                                                                       \
    WORD("cbmti$cs", SET_IGNORED)                                                                                      \
    WORD("xzeroa$xis", SET_IGNORED)                                                                                    \
    WORD("x2zeroa$xis", SET_IGNORED)                                                                                   \
    WORD("yzeroa$xis", SET_IGNORED)                                                                                    \
    WORD("y2zeroa$xis", SET_IGNORED)                                                                                   \
    WORD("zzeroa$xis", SET_IGNORED)                                                                                    \
    WORD("zeroa$xis", SET_IGNORED)                                                                                     \
    WORD("z$ero", SET_IGNORED)                                                                                         \
    OPTIONS_OURS(WORD)
const char words_set[] = OPTIONS(WORDS_PATTERN);
const uint8_t words_set_id[] = {OPTIONS(WORDS_ID)};
_Static_assert(sizeof words_set_id <= WORDS_SET_MAX, "a warning bit for each");

#define STYLES(WORD)                                                                                                   \
    WORD("l$ines", STYLE_LINES)                                                                                        \
    WORD("i$mpulses", STYLE_OTHER)                                                                                     \
    WORD("p$oints", STYLE_OTHER)                                                                                       \
    WORD("linesp$oints", STYLE_OTHER)                                                                                  \
    WORD("lp", STYLE_OTHER)                                                                                            \
    WORD("d$ots", STYLE_OTHER)                                                                                         \
    WORD("steps", STYLE_OTHER)                                                                                         \
    WORD("fs$teps", STYLE_OTHER)                                                                                       \
    WORD("his$teps", STYLE_OTHER)                                                                                      \
    WORD("fillst$eps", STYLE_OTHER)                                                                                    \
    WORD("e$rrorbars", STYLE_OTHER)                                                                                    \
    WORD("xe$rrorbars", STYLE_OTHER)                                                                                   \
    WORD("ye$rrorbars", STYLE_OTHER)                                                                                   \
    WORD("xye$rrorbars", STYLE_OTHER)                                                                                  \
    WORD("ze$rrorfill", STYLE_OTHER)                                                                                   \
    WORD("errorl$ines", STYLE_OTHER)                                                                                   \
    WORD("xerrorl$ines", STYLE_OTHER)                                                                                  \
    WORD("yerrorl$ines", STYLE_OTHER)                                                                                  \
    WORD("xyerrorl$ines", STYLE_OTHER)                                                                                 \
    WORD("boxes", STYLE_OTHER)                                                                                         \
    WORD("boxer$rorbars", STYLE_OTHER)                                                                                 \
    WORD("boxx$yerror", STYLE_OTHER)                                                                                   \
    WORD("boxplot", STYLE_OTHER)                                                                                       \
    WORD("hist$ograms", STYLE_OTHER)                                                                                   \
    WORD("filledc$urves", STYLE_OTHER)                                                                                 \
    WORD("vec$tors", STYLE_OTHER)                                                                                      \
    WORD("arrow$s", STYLE_OTHER)                                                                                       \
    WORD("fin$ancebars", STYLE_OTHER)                                                                                  \
    WORD("can$dlesticks", STYLE_OTHER)                                                                                 \
    WORD("pm$3d", STYLE_OTHER)                                                                                         \
    WORD("labels", STYLE_OTHER)                                                                                        \
    WORD("ima$ge", STYLE_OTHER)                                                                                        \
    WORD("rgbima$ge", STYLE_OTHER)                                                                                     \
    WORD("rgba$lpha", STYLE_OTHER)                                                                                     \
    WORD("cir$cles", STYLE_OTHER)                                                                                      \
    WORD("ell$ipses", STYLE_OTHER)                                                                                     \
    WORD("su$rface", STYLE_LINES)                                                                                      \
    WORD("parallel$axes", STYLE_OTHER)                                                                                 \
    WORD("polygons", STYLE_OTHER)                                                                                      \
    WORD("table", STYLE_OTHER)                                                                                         \
    WORD("isosurface", STYLE_OTHER)                                                                                    \
    WORD("spiderplot", STYLE_OTHER)                                                                                    \
    WORD("mask", STYLE_OTHER)
const char words_style[] = STYLES(WORDS_PATTERN);
const uint8_t words_style_id[] = {STYLES(WORDS_ID)};
