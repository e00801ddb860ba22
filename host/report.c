/* report.c - the numbers of a page, twice. */
#include "host/report.h"

#include "hal/hal.h"
#include "version.h"

static double compute_s(const report_t *r) {
    return r->measure_s + r->hide_s + r->order_s;
}

static double plotting_s(const report_t *r) {
    return (double)r->motion.ticks / HAL_TICK_HZ;
}

/* What the core worked in: what was used of the picture's block, data, and the planner's and queue's. */
static size_t working_bytes(const report_t *r) {
    const picture_stats_t *p = &r->picture;
    return p->kernel_bytes + r->path_bytes + p->map_bytes + p->cache_bytes + r->data_bytes + r->motion.memory_bytes;
}

void report_table_head(FILE *f) {
    fprintf(f, "%-22s %9s %10s %11s %10s %7s %10s %13s\n", "scene", "facets", "compute", "pen down", "pen up", "lifts",
            "plotting", "memory");
}

void report_table_row(FILE *f, const report_t *r) {
    char name[64], plotting[32];
    if (r->page > 1)
        snprintf(name, sizeof name, "%.40s, page %d", r->name, r->page);
    else
        snprintf(name, sizeof name, "%.60s", r->name);
    if (r->machine_error)
        snprintf(plotting, sizeof plotting, "-");
    else
        snprintf(plotting, sizeof plotting, "%.1f s", plotting_s(r));
    fprintf(f, "%-22s %9lld %7.1f ms %8.0f mm %7.0f mm %7zu %10s %11zu B\n", name, (long long)r->picture.facets,
            compute_s(r) * 1e3, r->length.down_mm, r->length.up_mm, r->strokes, plotting, working_bytes(r));
    fflush(f);
}

/* A JSON string: quotes, backslashes and control characters escaped; other bytes are UTF-8 already or pass for it. */
static void put_string(FILE *f, const char *s) {
    fputc('"', f);
    for (; *s; s++) {
        unsigned char c = (unsigned char)*s;
        if (c == '"' || c == '\\')
            fprintf(f, "\\%c", c);
        else if (c < 0x20)
            fprintf(f, "\\u%04x", c);
        else
            fputc(c, f);
    }
    fputc('"', f);
}

void report_json_begin(FILE *f, const char *scene) {
    fputs("{\n  \"program\": \"ridgeline\",\n  \"version\": \"" RIDGELINE_VERSION "\",\n  \"scene\": ", f);
    put_string(f, scene);
    fputs(",\n  \"pages\": [", f);
}

void report_json_page(FILE *f, const report_t *r) {
    const picture_stats_t *p = &r->picture;
    fprintf(f, "%s\n    {\n      \"page\": %d,\n      \"title\": ", r->page > 1 ? "," : "", r->page);
    put_string(f, r->title);
    fputs(",\n      \"files\": [", f);
    for (size_t i = 0; r->file[i]; i++) {
        if (i) fputs(", ", f);
        put_string(f, r->file[i]);
    }
    fprintf(f, "],\n      \"facets\": %lld,\n      \"points_evaluated\": %lld,\n", (long long)p->facets,
            (long long)p->evaluated);
    fprintf(f,
            "      \"compute_s\": %.6f,\n      \"stage_s\": {\"measure\": %.6f, \"hide\": %.6f, \"order\": %.6f, "
            "\"write\": %.6f},\n",
            compute_s(r), r->measure_s, r->hide_s, r->order_s, r->write_s);
    fprintf(f,
            "      \"pen_down_mm\": %.3f,\n      \"pen_up_mm\": %.3f,\n      \"strokes\": %zu,\n      \"lifts\": %zu,\n"
            "      \"segments\": %zu,\n",
            r->length.down_mm, r->length.up_mm, r->strokes, r->strokes, r->points - r->strokes);
    if (r->machine_error)
        fprintf(f, "      \"plotting_s\": null,\n");
    else
        fprintf(f, "      \"plotting_s\": %.6f,\n", plotting_s(r));
    fprintf(f,
            "      \"memory_bytes\": {\"hidden\": %zu, \"path\": %zu, \"map\": %zu, \"heights\": %zu, \"data\": %zu, "
            "\"motion\": %u, \"total\": %zu, \"lent\": %zu},\n",
            p->kernel_bytes, r->path_bytes, p->map_bytes, p->cache_bytes, r->data_bytes,
            (unsigned)r->motion.memory_bytes, working_bytes(r), r->lent_bytes);
    fprintf(f,
            "      \"hidden\": {\"edges\": %lld, \"tests\": %lld, \"crossings\": %lld, \"pieces\": %lld, "
            "\"peak_upper\": %d, \"peak_lower\": %d},\n",
            (long long)p->hidden.edges, (long long)p->hidden.tests, (long long)p->hidden.crossings,
            (long long)p->hidden.pieces, (int)p->hidden.peak_upper, (int)p->hidden.peak_lower);
    fprintf(f, "      \"path\": {\"runs\": %lld, \"dots\": %lld, \"vertices\": %lld, \"flushes\": %lld}\n    }",
            (long long)p->path.runs, (long long)p->path.dots, (long long)p->path.vertices, (long long)p->path.flushes);
}

void report_json_end(FILE *f) {
    fputs("\n  ]\n}\n", f);
}
