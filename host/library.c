/* library.c - dlopen and dlsym. */
#include "host/library.h"

#include <dlfcn.h>
#include <string.h>

static const char *trouble = "";

bool library_load(const char *soname, const char *const *name, size_t n, void *table) {
    void *library = dlopen(soname, RTLD_NOW | RTLD_LOCAL);
    for (size_t i = 0; library && i < n; i++) {
        void *function = dlsym(library, name[i]);
        if (!function) library = NULL;
        memcpy((char *)table + i * sizeof function, &function, sizeof function);
    }
    if (library) return true;
    trouble = dlerror();
    return false;
}

const char *library_error(void) {
    return trouble ? trouble : "";
}
