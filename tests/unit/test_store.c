/* store.h: what is kept when the power fails at any byte of a write. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>

#include <cmocka.h>

#include "app/store.h"
#include "error.h"
#include "sim/sim.h"
#include "sim/sim_console.h"

static union {
    uint64_t align;
    char bytes[3 * HAL_STORE_BYTES];
} memory;
static store_record_t *const record = (store_record_t *)&memory;

static int new_store(void **state) {
    (void)state;
    sim_reset();
    sim_console_reset();
    sim_store_erase();
    return 0;
}

static int save(enum store_kind kind, const char *text) {
    memcpy(record->text, text, strlen(text));
    return store_save(kind, record, strlen(text), sizeof memory);
}

static const char *load(enum store_kind kind) {
    memset(&memory, 0x55, sizeof memory);
    int n = store_load(kind, record, sizeof memory);
    if (n < 0) return NULL;
    assert_int_equal(strlen(record->text), n);
    return record->text;
}

static void test_round_trip(void **state) {
    (void)state;
    assert_null(load(STORE_SCENE));
    assert_null(load(STORE_SETTINGS));
    assert_int_equal(save(STORE_SCENE, "first"), 0);
    assert_string_equal(load(STORE_SCENE), "first");
    assert_null(load(STORE_SETTINGS));
    assert_int_equal(save(STORE_SETTINGS, "other"), 0);
    for (int i = 0; i < 20; i++) {
        char text[32];
        snprintf(text, sizeof text, "text number %*d", i, i);
        assert_int_equal(save(STORE_SCENE, text), 0);
        assert_string_equal(load(STORE_SCENE), text);
        assert_string_equal(load(STORE_SETTINGS), "other");
    }
    assert_int_equal(save(STORE_SCENE, ""), 0);
    assert_string_equal(load(STORE_SCENE), "");
}

static void test_sizes(void **state) {
    (void)state;
    char text[STORE_TEXT_MAX + 2];
    memset(text, 'x', sizeof text);
    text[STORE_TEXT_MAX + 1] = '\0';
    assert_int_equal(save(STORE_SCENE, text), ERR_FULL);
    text[STORE_TEXT_MAX] = '\0';
    assert_int_equal(save(STORE_SCENE, text), 0);
    assert_string_equal(load(STORE_SCENE), text);
    assert_int_equal(store_save(STORE_SCENE, record, 100, 200), ERR_FULL); /* no room to look at the slots */
    assert_int_equal(store_load(STORE_SCENE, record, 100), ERR_EMPTY);     /* does not fit */
}

/* The same text again costs no erasing. */
static void test_unchanged(void **state) {
    (void)state;
    save(STORE_SCENE, "same");
    sim_store_cut(0);
    assert_int_equal(save(STORE_SCENE, "same"), 0);
    assert_int_equal(save(STORE_SCENE, "another"), ERR_FILE);
}

/* Power fails after every number of bytes, in every state of the two slots: the old text or the new one, never
 * another, and the next write works. */
static void test_power_cut(void **state) {
    (void)state;
    char old[64], new[64];
    int kept_old = 0, kept_new = 0;
    for (int before = 0; before < 3; before++) {
        for (uint32_t cut = 0; cut < 80; cut++) {
            new_store(NULL);
            for (int i = 0; i < before; i++) {
                snprintf(old, sizeof old, "the old scene, kept %d times, and a bit longer", i + 1);
                assert_int_equal(save(STORE_SCENE, old), 0);
            }
            snprintf(new, sizeof new, "the new scene at %u", (unsigned)cut);
            sim_store_cut(cut);
            int err = save(STORE_SCENE, new);
            sim_console_reset(); /* power is back */
            const char *text = load(STORE_SCENE);
            if (err == 0) {
                assert_string_equal(text, new);
            } else if (before == 0) {
                assert_true(!text || strcmp(text, new) == 0);
            } else {
                assert_true(strcmp(text, old) == 0 || strcmp(text, new) == 0);
            }
            if (text && strcmp(text, new) == 0)
                kept_new++;
            else
                kept_old++;
            assert_int_equal(save(STORE_SCENE, "after"), 0);
            assert_string_equal(load(STORE_SCENE), "after");
        }
    }
    printf("# power cut at every byte of a write: %d times the old text, %d times the new one\n", kept_old, kept_new);
}

/* A bit that has turned over is noticed; the slot before it counts again. */
static void test_decay(void **state) {
    (void)state;
    save(STORE_SCENE, "the older one");
    save(STORE_SCENE, "the newer one");
    static union {
        uint32_t align;
        uint8_t bytes[64];
    } raw;
    for (size_t bit = 0; bit < 8 * (sizeof(store_record_t) + 13); bit++) {
        hal_store_read(1, &raw, sizeof raw);
        raw.bytes[bit / 8] ^= (uint8_t)(1 << bit % 8);
        hal_store_write(1, &raw, sizeof raw);
        assert_string_equal(load(STORE_SCENE), "the older one");
        raw.bytes[bit / 8] ^= (uint8_t)(1 << bit % 8);
        hal_store_write(1, &raw, sizeof raw);
    }
    assert_string_equal(load(STORE_SCENE), "the newer one");
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup(test_round_trip, new_store), cmocka_unit_test_setup(test_sizes, new_store),
        cmocka_unit_test_setup(test_unchanged, new_store),  cmocka_unit_test_setup(test_power_cut, new_store),
        cmocka_unit_test_setup(test_decay, new_store),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
