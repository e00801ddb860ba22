/* The census: "alone" is never said of an end with a neighbour. */
#include "path/census.h"
#include "path_scene.h"

static page_point_t somewhere(uint32_t *seed, int32_t across) {
    int32_t x = (int32_t)(next_random(seed) % (uint32_t)across) - across / 2;
    return (page_point_t){x, (int32_t)(next_random(seed) % (uint32_t)across) - across / 2};
}

static bool is_near(page_point_t a, page_point_t b, int32_t near_lat) {
    int64_t dx = (int64_t)a.x_lat - b.x_lat, dy = (int64_t)a.y_lat - b.y_lat;
    return dx * dx + dy * dy <= (int64_t)near_lat * near_lat;
}

static void nobody_with_a_neighbour_is_alone(void **state) {
    enum { ENDS = 600 };
    (void)state;
    uint32_t seed = 7;
    static const int32_t across[] = {1, 2000, 40000, 1 << 20};
    int64_t alone = 0, lonely = 0;
    for (int round = 0; round < 40; round++) {
        static page_point_t p[ENDS];
        static uint32_t mem[ENDS * 8];
        census_t c;
        size_t bytes = round % 3 == 0 ? CENSUS_BYTES_MIN : sizeof mem;
        census_init(&c, mem, bytes, ENDS, 10);
        for (int i = 0; i < ENDS; i++) {
            p[i] = somewhere(&seed, across[round % 4]);
            /* every other one close to the one before, at about the distance that counts */
            if (i & 1 && round < 20)
                p[i] = (page_point_t){p[i - 1].x_lat + (int32_t)(next_random(&seed) % 200), p[i - 1].y_lat};
            census_enter(&c, p[i]);
        }
        for (int i = 0; i < ENDS; i++) {
            bool has = false;
            for (int k = 0; k < ENDS; k++) has = has || (k != i && is_near(p[i], p[k], 102));
            bool said = census_is_alone(&c, p[i], 102);
            assert_false(has && said);
            if (round >= 20 && round % 4 == 3 && round % 3 != 0) alone += said, lonely += !has;
        }
    }
    printf("# census: %d of %d ends without a neighbour are known to be alone\n", (int)alone, (int)lonely);
    assert_true(alone * 10 > lonely * 6); /* the rest have somebody in their cell, or theirs is shared */
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(nobody_with_a_neighbour_is_alone),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
