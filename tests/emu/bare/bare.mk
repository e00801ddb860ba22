# bare.mk - programs of tests/emu/bare (bare.h): for the host, and for bare cores in emulators.
comma := ,
BARE := $(EMUDIR)/bare
# A core: its compiler's name for it, code, data and top of the stack. m0 is the micro:bit's memory; the others, which are to hold large
# scenes, the AN385's (a Cortex-M3, which runs a Cortex-M0's instructions as they are) and a Pico's flash and RAM.
BARE_m0     := -mcpu=cortex-m0 0 0x20000000 0x20004000
BARE_m0an   := -mcpu=cortex-m0 0 0x20000000 0x20400000
BARE_m3     := -mcpu=cortex-m3 0 0x20000000 0x20400000
BARE_rp2040 := -mcpu=cortex-m0plus 0x10000000 0x20000000 0x20042000
BARE_CFLAGS := -std=c11 -O2 -ffreestanding -ffunction-sections -fdata-sections $(WARN) -MMD -MP -Isrc -I.
bare_lds     = -nostartfiles --specs=nano.specs -mthumb -Wl,--gc-sections -Wl,--fatal-warnings -T tests/emu/bare/bare.ld \
    $(foreach k,2 3 4,-Wl,--defsym=$(word $k,- CODE DATA STACK)=$(word $k,$(or $(BARE_$1_$2),$(BARE_$1))))
BARE_COMMON := tests/emu/bare/integer_scene.c
# The same scenes everywhere: small ones, and large ones to count by. The folders that the kernels need; what is not called is left out by the linker.
BARE_CORE := $(filter src/error.c src/num/% src/scene/% src/view/% src/hidden/% src/poly/%,$(CORE_SRC))
BARE_DEFS_count := -DINTEGER_SCENE_SIDE=40 -DINTEGER_SCENE_BYTES=106496

define bare_core
$(BARE)/$1-$2/%.o: %.c
	@mkdir -p $$(@D)
	$$(call say,CC,$1 $$<)
	$$(Q)$(CROSS)gcc $(word 1,$(BARE_$1)) -mthumb $(BARE_CFLAGS) $(BARE_DEFS_$2) -c $$< -o $$@
$(BARE)/$2-$1.elf: $(patsubst %.c,$(BARE)/$1-$2/%.o,tests/emu/bare/$2.c tests/emu/bare/bare_arm.c $(BARE_COMMON) $(BARE_SRC_$2) $(BARE_CORE)) tests/emu/bare/bare.ld
	$$(call say,LD,$$@)
	$$(Q)$(CROSS)gcc $(word 1,$(BARE_$1)) $(call bare_lds,$1,$2) $(BARE_LDS_$2) $$(filter %.o,$$^) $(BARE_LIBS_$2) -o $$@
	$$(Q)$(CROSS)objcopy -O binary $$@ $$(@:.elf=.bin)
endef
# The area sort takes more memory than a micro:bit has: solids are run on the AN385.
BARE_SRC_same        := tests/emu/bare/same_main.c
BARE_SRC_same_numbers := $(BARE_SRC_same)
BARE_SRC_same_solids := $(BARE_SRC_same) tests/emu/bare/integer_solids.c src/lang/settings.c src/motion/machine.c
$(eval $(call bare_core,m0,same))
$(eval $(call bare_core,m3,same))
$(eval $(call bare_core,m0,same_numbers))
$(eval $(call bare_core,m3,same_numbers))
$(eval $(call bare_core,m0an,same_solids))
$(eval $(call bare_core,m3,same_solids))
define bare_same
$(BARE)/$1: $(patsubst %.c,$(BUILDDIR)/obj/%.o,tests/emu/bare/$1.c tests/emu/bare/bare_host.c $(BARE_COMMON) $(filter tests/%,$(BARE_SRC_$1))) $(BUILDDIR)/libcore.a
	@mkdir -p $$(@D)
	$$(call say,LD,$$@)
	$$(Q)$$(CC) $$(LDFLAGS) $$^ -o $$@
endef
$(eval $(call bare_same,same))
$(eval $(call bare_same,same_numbers))
$(eval $(call bare_same,same_solids))
BARE_SAME := $(addprefix $(BARE)/,same same-m0.elf same-m3.elf same_numbers same_numbers-m0.elf same_numbers-m3.elf same_solids same_solids-m0an.elf same_solids-m3.elf)
$(BARE)/counter.so: tests/emu/bare/counter.c
	@mkdir -p $(@D)
	$(Q)$(CC) -shared -fPIC -O2 -Wall -Wextra -o $@ $<
BOARD_NEEDS += $(BARE_SAME)

# What is counted for `make report` (tests/report/boards.sh).
BARE_SRC_count  := tests/emu/bare/formats.c tests/report/lattice.c
BARE_LDS_count  := $(addprefix -Wl$(comma)--wrap=,chart_row horizons_clip windows_insert)
BARE_LIBS_count := -lm
# Solids apart: once for each number of bits of their lattice, which two
# sources know (scene/solid.h); all others are those of the program that is shipped.
BARE_DEFS_count_solids := -DCOUNT_BYTES=98304 -D_DEFAULT_SOURCE
BARE_SRC_count_solids  := tests/emu/bare/count_bodies.c tests/oracle/halo_scenes.c src/lang/settings.c src/motion/machine.c
BARE_LIBS_count_solids := -lm
COUNT_CORES := m0an m3 rp2040
$(foreach c,$(COUNT_CORES),$(eval $(call bare_core,$c,count)) $(eval $(call bare_core,$c,count_solids)))
COUNT_BITS := 14 16 18 22
BARE_OWN   := tests/emu/bare/count_solids.o src/scene/solid.o src/view/solid_map.o
define bare_bits
$(BARE)/$1-count_solids_$2/%.o: %.c
	@mkdir -p $$(@D)
	$$(call say,CC,$1 $$<)
	$$(Q)$(CROSS)gcc $(word 1,$(BARE_$1)) -mthumb $(BARE_CFLAGS) $(BARE_DEFS_count_solids) -DSOLID_BITS=$2 -c $$< -o $$@
$(BARE)/count_solids_$2-$1.elf: $(BARE)/count_solids-$1.elf $(BARE_OWN:%=$(BARE)/$1-count_solids_$2/%)
	$$(call say,LD,$$@)
	$$(Q)$(CROSS)gcc $(word 1,$(BARE_$1)) $(call bare_lds,$1,count_solids) $$(filter %.o,$$^) \
	    $(filter-out $(BARE_OWN:%=$(BARE)/$1-count_solids/%),$(patsubst %.c,$(BARE)/$1-count_solids/%.o,tests/emu/bare/bare_arm.c $(BARE_COMMON) $(BARE_SRC_count_solids) $(BARE_CORE))) -lm -o $$@
	$$(Q)$(CROSS)objcopy -O binary $$@ $$(@:.elf=.bin)
endef
$(foreach c,$(COUNT_CORES),$(foreach b,$(COUNT_BITS),$(eval $(call bare_bits,$c,$b))))
COUNT_PROGRAMS := count count_solids $(COUNT_BITS:%=count_solids_%)
BARE_COUNTS := $(foreach c,$(COUNT_CORES),$(COUNT_PROGRAMS:%=$(BARE)/%-$c.elf)) $(BARE)/counter.so $(EMUDIR)/node_modules/.ready
