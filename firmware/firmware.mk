# firmware.mk - images of the boards, included by the Makefile.
include firmware/boards.mk

CROSS    ?= arm-none-eabi-
FWDIR    := $(BUILDDIR)/firmware
FW_CFLAGS := -std=c11 -mthumb -ffreestanding -ffunction-sections -fdata-sections -g $(WARN) -MMD -MP
FW_LDFLAGS := -mthumb -nostartfiles --specs=nano.specs -Wl,--gc-sections -Wl,--emit-relocs -Wl,--fatal-warnings -Llinker
FW_SRC   := $(wildcard firmware/*.c) $(CORE_SRC)

.PHONY: firmware firmware-run flash-pico flash-microbit
firmware: ## build the images of all boards; prints flash, RAM and a bound of the stack
	$(Q)sh .ci/deps.sh firmware
	+$(Q)$(again) firmware-run

# What is said to people lies packed in flash: these sources, which say it, are compiled from copies (firmware/tools/pack_texts.c).
SAYING   := src/error.c src/scene/data_grid.c $(wildcard src/lang/*.c src/app/*.c)
define board
compile_$1 = $(CROSS)gcc -Isrc -I. -Ihal/$1 $$(CPU_$1) $$(OPT_$1) $$(addprefix -D,$$(CONFIG_$1)) $(UNSET:%=-U%) -DPACKED_PAIRS='"firmware/pairs.txt"' $$(FW_CFLAGS)
FW_OBJ_$1 := $$(patsubst %,$(FWDIR)/$1/%.o,$$(basename $$(FW_SRC) $$(wildcard hal/port/*.c hal/$1/*.c hal/$1/*.S)))
$(FWDIR)/$1/%.o: %.c firmware/boards.mk
	@mkdir -p $$(@D)
	$$(call say,CC,$1 $$<)
	$$(Q)$$(compile_$1) -c $$< -o $$@
$(FWDIR)/$1/pack_texts: firmware/tools/pack_texts.c src/lang/help_texts.h src/config.h src/said.h firmware/boards.mk
	@mkdir -p $$(@D)
	$$(Q)$(CC) -O1 -Wall -Wextra -Wno-missing-braces -Isrc $$(addprefix -D,$$(CONFIG_$1)) $$< -o $$@
$(FWDIR)/$1/help.h: $(FWDIR)/$1/pack_texts firmware/pairs.txt
	$$(Q)$$< help firmware/pairs.txt >$$@
$(SAYING:%.c=$(FWDIR)/$1/%.o): $(FWDIR)/$1/%.o: $(FWDIR)/said/%.c firmware/boards.mk
	@mkdir -p $$(@D)
	$$(call say,CC,$1 $$*.c)
	$$(Q)$$(compile_$1) -c $$< -o $$@
$(FWDIR)/$1/src/said.o: firmware/pairs.txt
$(FWDIR)/$1/src/lang/help.o: $(FWDIR)/$1/help.h
$(FWDIR)/$1/src/lang/help.o: FW_CFLAGS += -DHELP_PACKED='"$(FWDIR)/$1/help.h"'
$(FWDIR)/$1/%.o: %.S
	@mkdir -p $$(@D)
	$$(Q)$(CROSS)gcc $$(CPU_$1) -mthumb -c $$< -o $$@
$(FWDIR)/$1.elf: $$(FW_OBJ_$1) linker/$1.ld linker/sections.ld
	$$(call say,LD,$$@)
	$$(Q)$(CROSS)gcc $$(CPU_$1) $$(OPT_$1) $(FW_LDFLAGS) -T linker/$1.ld -Wl,-Map=$$(@:.elf=.map) $$(FW_OBJ_$1) -o $$@
endef
$(foreach b,$(BOARDS),$(eval $(call board,$b)))
$(SAYING:%=$(FWDIR)/said/%): $(FWDIR)/said/%: % firmware/pairs.txt $(FWDIR)/nrf51/pack_texts
	@mkdir -p $(@D)
	$(Q)$(FWDIR)/nrf51/pack_texts source firmware/pairs.txt $< >$@
.PHONY: pairs
pairs: $(FWDIR)/nrf51/pack_texts ## learn anew which bytes of texts stand for two in the boards' flash (firmware/pairs.txt)
	$(Q)$< learn $(SAYING) >firmware/pairs.txt
IMAGES := $(BOARDS:%=$(FWDIR)/%.elf) $(FWDIR)/rp2040.bin $(FWDIR)/nrf51.hex

# The step interrupt is worth its bytes on the smallest part, too.
$(FWDIR)/nrf51/src/motion/stepgen_isr.o $(FWDIR)/nrf51/src/motion/stepgen_pulses.o $(FWDIR)/nrf51/hal/port/ahead.o $(FWDIR)/nrf51/hal/nrf51/player.o: OPT_nrf51 := -O2 -flto=auto

# What the linker asks for when all else is compiled cannot be compiled with it.
$(foreach b,$(BOARDS),$(FWDIR)/$b/firmware/strings.o): FW_CFLAGS += -Os -fno-lto -fno-builtin -fno-tree-loop-distribute-patterns

$(FWDIR)/uf2: firmware/tools/uf2.c
	@mkdir -p $(@D)
	$(Q)$(CC) -O2 -Wall -Wextra $< -o $@
$(FWDIR)/rp2040.bin: $(FWDIR)/rp2040.elf $(FWDIR)/uf2
	$(Q)$(CROSS)objcopy -O binary $< $@.raw
	$(Q)$(FWDIR)/uf2 $@.raw $@ $(@:.bin=.uf2)

$(FWDIR)/nrf51.hex: $(FWDIR)/nrf51.elf
	$(Q)$(CROSS)objcopy -O ihex $< $@

firmware-run: $(IMAGES)
	$(Q)CROSS=$(CROSS) sh firmware/tools/sizes.sh $(FWDIR) $(BOARDS)

flash-pico: ## how to bring the image onto a Raspberry Pi Pico
	$(Q)sh .ci/deps.sh firmware
	+$(Q)$(MAKE) --no-print-directory $(FWDIR)/rp2040.bin
	@echo 'Hold BOOTSEL while plugging the Pico in, then copy $(FWDIR)/rp2040.uf2 to the drive RPI-RP2.'
	@echo 'It restarts by itself; the console is on GP0 (out) and GP1 (in), 115200 8N1.'

flash-microbit: ## how to bring the image onto a BBC micro:bit (version 1)
	$(Q)sh .ci/deps.sh firmware
	+$(Q)$(MAKE) --no-print-directory $(FWDIR)/nrf51.hex
	@echo 'Plug the micro:bit (version 1, nRF51822) in, then copy $(FWDIR)/nrf51.hex to the drive MICROBIT.'
	@echo 'It restarts by itself; the console is the serial port of its USB, 115200 8N1.'
