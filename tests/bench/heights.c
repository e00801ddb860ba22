/* heights - uniform random heights (table1.h) as a data file: `x y z` a line, an empty one after each row.
 *
 *     heights N */
#include <stdio.h>
#include <stdlib.h>

#include "tests/bench/table1.h"

int main(int argc, char **argv) {
    const int n = argc == 2 ? atoi(argv[1]) : 0;
    if (n < 2) return 2;
    double *z = malloc((size_t)n * (size_t)n * sizeof *z);
    if (!z) return 1;
    table1_heights("random", n, z);
    for (int j = 0; j < n; j++) {
        for (int i = 0; i < n; i++)
            printf("%.6f %.6f %.6f\n", table1_coordinate(n, i), table1_coordinate(n, j),
                   z[(size_t)j * (size_t)n + (size_t)i]);
        putchar('\n');
    }
    free(z);
    return ferror(stdout) != 0;
}
