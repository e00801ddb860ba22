# emu.mk - the images run in emulators, watched from outside, against the same program on the simulator.
EMUDIR := $(BUILDDIR)/emu
# Pools are as large as their items, so the simulator of a board is built with the board's sizes: 32-bit pointers, 64-bit
# integers on 8 bytes, enumerations as small as their values. Elsewhere than on x86 it draws large scenes in another order.
EMU_ABI := $(if $(filter x86_64,$(shell uname -m)),-m32 -malign-double -fshort-enums)
define sim_board
$(EMUDIR)/obj-$1/firmware/main.o: CPPFLAGS += -Dmain=firmware_main -Wno-missing-prototypes
$(EMUDIR)/obj-$1/%.o: %.c firmware/boards.mk
	@mkdir -p $$(@D)
	$$(call say,CC,$1 $$<)
	$$(Q)$(CC) $(CFLAGS) $(EMU_ABI) $$(CPPFLAGS) $$(addprefix -D,$$(CONFIG_$1)) $(UNSET:%=-U%) -c $$< -o $$@
$(EMUDIR)/sim-$1: $(patsubst %.c,$(EMUDIR)/obj-$1/%.o,firmware/main.c tests/emu/sim_main.c $(CORE_SRC) $(SIM_SRC))
	$$(call say,LD,$$@)
	$$(Q)$(CC) $(EMU_ABI) $$^ -o $$@
endef
$(foreach b,$(BOARDS),$(eval $(call sim_board,$b)))
# What boards say that scenes would need (tests/emu/needs.c).
define needs_board
$(EMUDIR)/needs-$1: $(patsubst %.c,$(EMUDIR)/obj-$1/%.o,tests/emu/needs.c $(CORE_SRC) $(SIM_SRC))
	$$(call say,LD,$$@)
	$$(Q)$(CC) $(EMU_ABI) $$^ -lm -o $$@
endef
$(foreach b,$(BOARDS),$(eval $(call needs_board,$b)))
BOARD_NEEDS += $(EMUDIR)/needs-nrf51 $(EMUDIR)/needs-lm3s6965

$(EMUDIR)/scope.so: $(wildcard tests/emu/scope*.c) $(wildcard tests/emu/*.h)
	@mkdir -p $(@D)
	$(Q)$(CC) -shared -fPIC -O2 -Wall -Wextra -o $@ $(filter %.c,$^)
$(EMUDIR)/count.so: tests/emu/count.c
	@mkdir -p $(@D)
	$(Q)$(CC) -shared -fPIC -O2 -Wall -Wextra -o $@ $<
# rp2040js, as the lock file says, outside of the source tree.
$(EMUDIR)/node_modules/.ready: tests/emu/package.json tests/emu/package-lock.json
	@mkdir -p $(EMUDIR)
	$(Q)cp tests/emu/package.json tests/emu/package-lock.json $(EMUDIR)
	$(Q)cd $(EMUDIR) && npm ci --silent --no-audit --no-fund >npm.log 2>&1 || { cat npm.log; exit 1; }
	$(Q)touch $@

.PHONY: try-pico try-m3 try-microbit
try-pico: ## the Pico's console in this terminal, on an emulated board: no hardware needed
	$(call try,rp2040,pico,$(FWDIR)/rp2040.bin $(EMUDIR)/node_modules/.ready)
try-m3: ## the same with the Cortex-M3
	$(call try,lm3s6965,m3,$(FWDIR)/lm3s6965.elf $(EMUDIR)/scope.so)
try-microbit: ## the same with the micro:bit
	$(call try,nrf51,microbit,$(FWDIR)/nrf51.elf $(EMUDIR)/scope.so)
define try
$(Q)sh .ci/deps.sh firmware emu
+$(Q)$(again) -s $3 >&2
$(Q)sh tests/emu/try.sh $1 $(BUILDDIR) $2
endef

include tests/emu/bare/bare.mk
BOARD_TESTS := $(wildcard tests/emu/test_*.sh)
BOARD_NEEDS += $(EMUDIR)/scope.so $(EMUDIR)/node_modules/.ready $(BOARDS:%=$(EMUDIR)/sim-%) $(IMAGES)
.PHONY: test-emu test-emu-run
test-emu: ## run every board's image in its emulator against the simulator
	$(Q)sh .ci/deps.sh host firmware emu
	+$(Q)$(again) test-emu-run
test-emu-run: host $(BOARD_NEEDS)
	$(Q)$(RUN_TESTS) $(BOARD_TESTS)

.PHONY: bench-fits bench-mcu bench-mcu-run bench-mcu-large
bench-mcu-large: host $(EMUDIR)/node_modules/.ready $(BUILDDIR)/firmware/rp2040.bin ## the Pico's largest scenes in its emulator, to the end (half an hour; LARGE="smooth 300")
	$(Q)node tests/emu/bench_mcu.mjs $(BUILDDIR) large
bench-mcu: ## cycles per facet, memory and stack on the boards, in emulators, beside gnuplot (SIZES="20 60" RANDOM="20")
	$(Q)sh .ci/deps.sh host firmware emu
	+$(Q)$(again) bench-mcu-run
bench-mcu-run: $(EMUDIR)/scope.so $(EMUDIR)/count.so $(EMUDIR)/node_modules/.ready $(IMAGES) $(BUILDDIR)/bench/cpu_time
	$(Q)node tests/emu/bench_mcu.mjs $(BUILDDIR)
bench-fits: $(EMUDIR)/sim-lm3s6965 $(EMUDIR)/sim-nrf51 ## the largest scenes that fit into the small boards' memory
	$(Q)sh tests/emu/bench_fits.sh $(BUILDDIR) lm3s6965 nrf51
# Images of their own, which no rate is too high for.
.PHONY: bench-rates bench-rates-run
bench-rates: ## the highest rate of steps of each board that is in time, in emulators
	$(Q)sh .ci/deps.sh host firmware emu
	+$(Q)$(again) bench-rates-run
bench-rates-run: host
	+$(Q)$(MAKE) --no-print-directory BUILDDIR=$(BUILDDIR)/rates UNSET=CONFIG_STEP_RATE bench-rates-images
	$(Q)RIDGELINE=$(RIDGELINE) sh tests/emu/bench_rates.sh $(BUILDDIR)/rates
.PHONY: bench-rates-images
bench-rates-images: $(EMUDIR)/scope.so $(EMUDIR)/node_modules/.ready $(BOARDS:%=$(EMUDIR)/sim-%) $(IMAGES)
