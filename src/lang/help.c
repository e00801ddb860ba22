/* help.c - help, help WORD: finds the topic of a word, and tells it. */
#include "lang/builtins.h"
#include "lang/session_parts.h"
#ifdef HELP_PACKED
#include HELP_PACKED
#else
#include "lang/help_texts.h"
#endif

#define TOPICS (sizeof topics / sizeof topics[0])

#ifdef HELP_PACKED
static void tell_topic(const session_port_t *port, size_t topic) {
    said_t p = said_text(packed);
    char part[32] = "";
    size_t n = 0;
    while (topic > 0) topic -= said_next(&p) == '\0';
    for (char c; (c = said_next(&p)) != '\0';) {
        part[n++] = c;
        part[n] = '\0';
        if (n < sizeof part - 1) continue;
        port->print(port->ctx, part);
        n = 0;
        part[0] = '\0';
    }
    port->print(port->ctx, part);
}
#else
static void tell_topic(const session_port_t *port, size_t topic) {
    port->print(port->ctx, topics[topic].text);
}
#endif

/* The topic that an abbreviated word has, or the number of topics. */
static size_t topic_of(const char *word, size_t len) {
    size_t k = 1;
    while (k < TOPICS && !words_match(topics[k].pattern, word, len)) k++;
    return k;
}

#if CONFIG_CONTROL
/* Words that are explained under another one. */
static const struct {
    const char *word, *topic;
} UNDER[] = {
    {"u$sing", "data"},        {"bin$ary", "data"},  {"i$ndex", "data"},         {"ev$ery", "data"},
    {"skip", "data"},          {"mat$rix", "data"},  {"nonuni$form", "data"},    {"trans$late", "solids"},
    {"ro$tate", "solids"},     {"sc$ale", "solids"}, {"translucent", "solids"},  {"t$itle", "splot"},
    {"not$itle", "splot"},     {"w$ith", "splot"},   {"for", "loops"},           {"ur$ange", "parametric"},
    {"vr$ange", "parametric"}, {"exists", "texts"},  {"pi", "functions"},        {"NaN", "functions"},
    {"va$riables", "show"},    {"all", "show"},      {"operators", "functions"}, {"home", "board"},
    {"stop", "board"},         {"unlock", "board"},  {"status", "board"},        {"memory", "board"},
    {"autorun", "board"},      {"motors", "board"},  {"save", "board"},
};

/* The topic of a word that has none of its own, or the number of topics. */
static size_t topic_under(const lexer_t *lx) {
    const char *word = lexer_text(lx), *under = "";
    const int function = builtins_find(word, lx->tok.len), command = words_find(words_command, lx);
    for (size_t k = 0; k < sizeof UNDER / sizeof UNDER[0] && !*under; k++)
        if (words_match(UNDER[k].word, word, lx->tok.len)) under = UNDER[k].topic;
    if (!*under && function >= 0) under = BUILTINS[function].flags & BUILTIN_TEXTS ? "texts" : "functions";
    if (!*under && command >= 0 && words_command_id[command] == CMD_CONTROL) under = "loops";
    return *under ? topic_of(under, strlen(under)) : TOPICS;
}

/* What is to be said of a word without a topic, or NULL. */
static const char *known(const lexer_t *lx) {
    const int command = words_find(words_command, lx), option = words_find(words_set, lx);
    if (command >= 0 && words_command_id[command] == CMD_UNSUPPORTED) return "a command of gnuplot's only\n";
    return command >= 0 || option >= 0 ? "gnuplot has it; here it is ignored\n" : NULL;
}
#endif

int help_command(session_t *s, lexer_t *lx) {
    lexer_t last = *lx; /* help set view is about view */
    size_t topic = 0;
    while (!session_at_end(lx)) {
        last = *lx;
        lexer_next(lx);
        topic = TOPICS;
    }
    if (CONFIG_CONTROL && lexer_is_almost(&last, "h$elp")) topic = 0;
    if (topic > 0 && last.tok.kind == TOKEN_NAME) topic = topic_of(lexer_text(&last), last.tok.len);
#if CONFIG_CONTROL
    if (topic == TOPICS && last.tok.kind == TOKEN_NAME) topic = topic_under(&last);
    const char *what = topic == TOPICS ? known(&last) : NULL;
    if (what) {
        s->port->print(s->port->ctx, what);
        return 0;
    }
#endif
    if (topic < TOPICS) {
        tell_topic(s->port, topic);
        return 0;
    }
    return lang_error_set_name(&s->error, ERR_NAME, lexer_column(&last), "try `help` alone; no help for",
                               lexer_text(&last), last.tok.len);
}
