/* bare.h on the host. */
#include "tests/emu/bare/bare.h"

#include <inttypes.h>
#include <stdio.h>

void bare_text(const char *s) {
    fputs(s, stdout);
}
void bare_number(int64_t v) {
    printf("%" PRId64, v);
}
void bare_hex(uint64_t v) {
    printf("%016" PRIx64, v);
}
void bare_mark(void) {}
int main(int argc, char **argv) {
    return bare_main(argc, argv);
}
