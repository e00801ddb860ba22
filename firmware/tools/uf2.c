/* uf2.c - makes a Pico's image out of what the linker left: fills in the boot loader's checksum and packs it as UF2,
 * the format that the boot ROM's drive takes.
 *
 *     uf2 IN.bin OUT.bin OUT.uf2 */
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define FLASH 0x10000000u
#define BOOT2_BYTES 252
#define PAYLOAD 256u
#define SECTOR 4096u /* whole ones: what shares an erased sector with the program would be lost */
#define IMAGE_MAX (2u << 20)
#define FAMILY_RP2040 0xe48bff56u

static uint8_t image[IMAGE_MAX];

/* Polynomial 04C11DB7, from all ones, not reflected, not inverted. */
static uint32_t crc32(const uint8_t *data, size_t bytes) {
    uint32_t crc = 0xffffffffu;
    for (size_t i = 0; i < bytes; i++) {
        crc ^= (uint32_t)data[i] << 24;
        for (int k = 0; k < 8; k++) crc = crc & 0x80000000u ? crc << 1 ^ 0x04c11db7u : crc << 1;
    }
    return crc;
}

static void put32(uint8_t *to, uint32_t value) {
    for (int i = 0; i < 4; i++) to[i] = (uint8_t)(value >> 8 * i);
}

static int fail(const char *name) {
    perror(name);
    return 1;
}

int main(int argc, char **argv) {
    if (argc != 4) return 2;
    FILE *in = fopen(argv[1], "rb");
    if (!in) return fail(argv[1]);
    memset(image, 0xff, sizeof image);
    size_t bytes = fread(image, 1, sizeof image, in);
    fclose(in);
    put32(image + BOOT2_BYTES, crc32(image, BOOT2_BYTES));

    FILE *bin = fopen(argv[2], "wb");
    if (!bin || fwrite(image, 1, bytes, bin) != bytes || fclose(bin)) return fail(argv[2]);
    FILE *uf2 = fopen(argv[3], "wb");
    if (!uf2) return fail(argv[3]);
    uint32_t blocks = ((uint32_t)bytes + SECTOR - 1) / SECTOR * (SECTOR / PAYLOAD);
    for (uint32_t i = 0; i < blocks; i++) {
        uint8_t block[512] = {0};
        const uint32_t head[8] = {0x0a324655u, 0x9e5d5157u, 0x2000u, FLASH + PAYLOAD * i,
                                  PAYLOAD,     i,           blocks,  FAMILY_RP2040};
        for (int k = 0; k < 8; k++) put32(block + 4 * k, head[k]);
        memcpy(block + 32, image + PAYLOAD * i, PAYLOAD);
        put32(block + 508, 0x0ab16f30u);
        if (fwrite(block, 1, sizeof block, uf2) != sizeof block) return fail(argv[3]);
    }
    return fclose(uf2) ? fail(argv[3]) : 0;
}
