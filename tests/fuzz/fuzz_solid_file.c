/* fuzz_solid_file.c - STL and OFF: any bytes become OBJ text or a complaint. */
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>

static FILE *nowhere;
static void progress_wipe_nothing(void) {}
#define progress_wipe progress_wipe_nothing
#include "host/progress.h"
#undef stderr
#define stderr nowhere
#include "host/solid_file.c"

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
    if (size < 2) return 0;
    if (!nowhere) nowhere = fopen("/dev/null", "w");
    if (!nowhere) abort();
    FILE *f = fmemopen((void *)(uintptr_t)(data + 1), size - 1, "r");
    if (!f) return 0;
    FILE *text = solid_file_open(f, data[0] & 1 ? "a.stl" : "a.off");
    if (!text) return 0;
    int c, start = 1;
    while ((c = fgetc(text)) != EOF) { /* lines of v and f, nothing else */
        if (start && c != 'v' && c != 'f') abort();
        start = c == '\n';
    }
    fclose(text);
    return 0;
}
