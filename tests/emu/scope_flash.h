/* scope_flash.h - the flash controller of the LM3S6965, which QEMU does not model, as its data sheet describes it: FMA,
 * FMD, FMC and USECRL. The image's own driver works it. What the chip would not do, or do wrong, is written to stderr,
 * where the test finds it: a command without the key, beside a word or page, while another is carried out, timed for
 * another clock than 50 MHz, a word that is not erased, or one outside of what the board keeps its settings in. */
#ifndef SCOPE_FLASH_H
#define SCOPE_FLASH_H

/* Before the first instruction. The part of the flash that may be written. */
void flash_connect(unsigned at, unsigned bytes);
/* A page or word that is being erased or written is half done. */
void flash_power_off(void);

#endif
