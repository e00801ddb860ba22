#include <stdio.h>
int main(void) {
    puts("ridgeline");
    return 0;
}
