/* library.h - shared libraries that are loaded when they are wanted.
 *
 * Cairo brings twenty libraries along, and finding them all takes three times as long as drawing a small scene. Only
 * .png, .pdf and the prompt need libraries; whoever writes .svg or .vcd does not wait for them, nor has to have them.
 */
#ifndef LIBRARY_H
#define LIBRARY_H

#include <stdbool.h>
#include <stddef.h>

/* Functions of a library as an X-macro, F(name) for each, make both the table that is filled in and the names to look
 * up: static struct { CAIRO(LIBRARY_POINTER) } cairo; static const char *const NAMES[] = {CAIRO(LIBRARY_NAME)};
 *     library_load("libcairo.so.2", NAMES, sizeof NAMES / sizeof *NAMES, &cairo) */
#define LIBRARY_POINTER(f) __typeof__(&f) f;
#define LIBRARY_NAME(f) #f,

/* Loads the library and looks up n functions into table, an array of pointers. False when the library or a function of
 * it is missing; library_error() then says which. It stays loaded. */
bool library_load(const char *soname, const char *const *name, size_t n, void *table);
const char *library_error(void);

#endif
