/* boot2.S - second stage boot loader: serial read (03h), execution in place, then the program's vector table at flash + 0x100.
 * The boot ROM copies the first 256 bytes of flash to RAM, checks the CRC32 in their last word (firmware/tools/uf2.c fills
 * it in) and enters here. 03h works on every flash chip; only the flash routines run from RAM. */
    .syntax unified
    .cpu cortex-m0plus
    .thumb
    .section .boot2, "ax"
    .global boot2
    .type boot2, %function
boot2:
    ldr r3, =0x18000000             /* XIP_SSI */
    movs r1, #0
    str r1, [r3, #0x08]             /* SSIENR: off */
    movs r1, #4
    str r1, [r3, #0x14]             /* BAUDR: clk_sys / 4 */
    ldr r1, =((31 << 16) | (3 << 8)) /* CTRLR0: 32 bits, EEPROM read */
    str r1, [r3, #0x00]
    movs r1, #0
    str r1, [r3, #0x04]             /* CTRLR1: one frame */
    ldr r1, =((0x03 << 24) | (2 << 8) | (6 << 2)) /* SPI_CTRLR0: command 03h of 8 bits, 24 address bits */
    movs r0, #0xf4
    adds r0, r0, r3
    str r1, [r0]
    movs r1, #1
    str r1, [r3, #0x08]             /* SSIENR: on */
    ldr r0, =0x10000100
    ldr r1, =0xe000ed08             /* VTOR */
    str r0, [r1]
    ldmia r0!, {r1, r2}
    msr msp, r1
    bx r2
    .ltorg
    .balign 4
