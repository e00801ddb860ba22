/* test_atomic_file.c - a file is the old one or the new one, whatever happens in between. */
#include <errno.h>
#include <fcntl.h>
#include <setjmp.h>
#include <signal.h>
#include <stdarg.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cmocka.h>

#include "error.h"
#include "host/out.h"

static char folder[64];
static out_t out;

static int make_folder(void **state) {
    (void)state;
    snprintf(folder, sizeof folder, "/tmp/ridgeline-test-XXXXXX");
    return mkdtemp(folder) && chdir(folder) == 0 ? 0 : -1;
}
static int remove_folder(void **state) {
    char command[96];
    (void)state;
    snprintf(command, sizeof command, "rm -rf '%s'", folder);
    return chdir("/") == 0 ? system(command) : -1;
}

static void expect_file(const char *name, const char *text) {
    char got[64] = "";
    FILE *f = fopen(name, "r");
    assert_non_null(f);
    got[fread(got, 1, sizeof got - 1, f)] = 0;
    fclose(f);
    assert_string_equal(got, text);
}

static void expect_files(int count) {
    char command[96];
    snprintf(command, sizeof command, "[ $(ls -A | wc -l) -eq %d ]", count);
    assert_int_equal(system(command), 0);
}

static void write_file(const char *name, const char *text) {
    assert_int_equal(out_open(&out, name), 0);
    out_text(&out, text);
    assert_int_equal(out_close(&out), 0);
}

static unsigned mode_of(const char *name) {
    struct stat s;
    assert_int_equal(stat(name, &s), 0);
    return s.st_mode & 07777;
}

static void nothing_is_there_before_all_is(void **state) {
    (void)state;
    umask(027);
    assert_int_equal(out_open(&out, "a"), 0);
    out_text(&out, "new");
    const bool unnamed = out.file.is_unnamed;
    expect_files(unnamed ? 0 : 1);
    assert_int_equal(out_close(&out), 0);
    expect_file("a", "new");
    assert_int_equal(mode_of("a"), 0640);
    expect_files(1);
    if (!unnamed) print_message("# no unnamed files here\n");
}

static void the_old_file_stays_until_then(void **state) {
    (void)state;
    write_file("a", "old");
    assert_int_equal(chmod("a", 0604), 0);
    if (out_open_unnamed(&out, "a")) {
        out_text(&out, "half of the n");
        expect_file("a", "old");
        out_drop(&out);
        expect_file("a", "old");
        assert_true(out_open_unnamed(&out, "a"));
        for (int k = 0; k < 200000; k++) out_text(&out, "again "); /* more than the buffer holds */
        out_restart(&out);
        out_text(&out, "new");
        expect_file("a", "old");
        assert_int_equal(out_close(&out), 0);
        expect_file("a", "new");
    }
    write_file("a", "newer");
    expect_file("a", "newer");
    assert_int_equal(mode_of("a"), 0604); /* as the user wanted it */
    expect_files(1);
}

/* The disk is full, say. */
static void what_cannot_be_written_is_not_lost(void **state) {
    (void)state;
    const struct rlimit little = {1 << 19, RLIM_INFINITY};
    struct rlimit usual;
    write_file("a", "old");
    assert_int_equal(getrlimit(RLIMIT_FSIZE, &usual), 0);
    signal(SIGXFSZ, SIG_IGN);
    assert_int_equal(setrlimit(RLIMIT_FSIZE, &little), 0);
    assert_int_equal(out_open(&out, "a"), 0);
    const bool unnamed = out.file.is_unnamed;
    for (int k = 0; k < 200000; k++) out_text(&out, "again ");
    const int err = out_close(&out), why = errno;
    assert_int_equal(setrlimit(RLIMIT_FSIZE, &usual), 0);
    assert_int_equal(err, ERR_FILE);
    assert_int_equal(why, EFBIG);
    expect_file("a", unnamed ? "old" : "");
    expect_files(1);
}

static void links_lead_to_the_same_file(void **state) {
    (void)state;
    write_file("a", "old");
    assert_int_equal(symlink("a", "soft"), 0);
    assert_int_equal(symlink("missing", "dangling"), 0);
    assert_int_equal(link("a", "hard"), 0);
    assert_false(out_open_unnamed(&out, "soft") || out_open_unnamed(&out, "dangling") ||
                 out_open_unnamed(&out, "hard"));
    write_file("soft", "through the link");
    expect_file("a", "through the link");
    write_file("hard", "new");
    expect_file("a", "new");
    write_file("dangling", "made");
    expect_file("missing", "made");
    expect_files(5);
    assert_int_equal(out_open(&out, "soft"), 0);
    out_text(&out, "half");
    out_drop(&out);
    expect_file("a", ""); /* not the half of anything */
    assert_int_equal(unlink("missing"), 0);
    assert_int_equal(out_open(&out, "dangling"), 0);
    out_drop(&out);
    expect_files(5); /* the link stays */
}

static void devices_and_folders(void **state) {
    (void)state;
    write_file("/dev/null", "gone");
    assert_int_equal(out_open(&out, "."), ERR_FILE);
    assert_int_equal(errno, EISDIR);
    assert_int_equal(out_open(&out, "nowhere/a"), ERR_FILE);
    assert_int_equal(errno, ENOENT);
    assert_int_equal(out_open(&out, "/dev/full"), 0);
    out_text(&out, "x");
    assert_int_equal(out_close(&out), ERR_FILE);
    assert_int_equal(errno, ENOSPC);
    expect_files(0);
}

/* Where the new file cannot be put in the old one's place, what it holds is copied: here the name has become too long
 * for another to stand beside it. */
static void copying_is_left(void **state) {
    char name[256];
    (void)state;
    memset(name, 'n', 255);
    name[255] = 0;
    write_file(name, "old");
    write_file(name, "new and longer");
    expect_file(name, "new and longer");
    write_file(name, "new");
    expect_file(name, "new");
    expect_files(1);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup_teardown(nothing_is_there_before_all_is, make_folder, remove_folder),
        cmocka_unit_test_setup_teardown(the_old_file_stays_until_then, make_folder, remove_folder),
        cmocka_unit_test_setup_teardown(what_cannot_be_written_is_not_lost, make_folder, remove_folder),
        cmocka_unit_test_setup_teardown(links_lead_to_the_same_file, make_folder, remove_folder),
        cmocka_unit_test_setup_teardown(devices_and_folders, make_folder, remove_folder),
        cmocka_unit_test_setup_teardown(copying_is_left, make_folder, remove_folder),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
