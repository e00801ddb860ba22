# Ridgeline. `make help` lists the targets; V=1 shows commands; BUILDDIR= moves what is built.
BUILDDIR ?= build
ifeq ($(origin CC),default)
CC := gcc
endif
AR       ?= ar
V        ?= 0
Q        := $(if $(filter 0,$(V)),@,)
say       = @$(if $(filter 0,$(V)),printf '  %-5s %s\n' $(1) '$(2)',:)
# Targets that build and then do something build with one job per processor, unless -j was given.
JOBS     ?= $(shell nproc 2>/dev/null || echo 1)
again     = $(MAKE) --no-print-directory $(if $(findstring jobserver,$(MAKEFLAGS)),,-j$(JOBS))

WARN     := -Wall -Wextra -Wconversion -Wshadow -Wstrict-prototypes -Wmissing-prototypes
# Functions begin on a line of the cache: how fast one is must not depend on what is linked before it (5 % was seen).
OPT      ?= -O3 -g -falign-functions=64
SANITIZE ?=
CFLAGS   += -std=c11 $(WARN) $(OPT) $(SANITIZE) -MMD -MP
CPPFLAGS += -Isrc -I. -D_DEFAULT_SOURCE
LDFLAGS  += $(SANITIZE)
# src/ is integers only: on x86-64 the compiler itself refuses a floating-point instruction there.
# Without those registers clang thinks that nothing can be prefetched; -mprfchw only tells it that it can.
COREFLAGS := $(if $(filter x86_64,$(shell uname -m)),-mgeneral-regs-only -mprfchw)

CORE_SRC := $(wildcard src/*.c src/*/*.c src/*/*/*.c)
SIM_SRC  := $(wildcard sim/*.c)
HOST_LIB_SRC := $(filter-out host/main.c,$(wildcard host/*.c))
ORACLE_SRC := $(wildcard tests/oracle/*.c)
TEST_KINDS := unit property hard trace
TESTS_SRC := $(foreach k,$(TEST_KINDS),$(wildcard tests/$k/test_*.c))
FUZZ_SRC := $(wildcard tests/fuzz/fuzz_*.c)
CLI_TESTS := $(wildcard tests/cli/test_*.sh)

CORE_OBJ := $(CORE_SRC:%.c=$(BUILDDIR)/obj/%.o)
SIM_OBJ  := $(SIM_SRC:%.c=$(BUILDDIR)/obj/%.o)
HOST_OBJ := $(HOST_LIB_SRC:%.c=$(BUILDDIR)/obj/%.o)
ORACLE_OBJ := $(ORACLE_SRC:%.c=$(BUILDDIR)/obj/%.o)
TESTS    := $(TESTS_SRC:tests/%.c=$(BUILDDIR)/tests/%)
FUZZERS  := $(FUZZ_SRC:tests/fuzz/%.c=$(BUILDDIR)/fuzz/%)
RIDGELINE := $(BUILDDIR)/host/ridgeline

# Asked once, and only when something that needs it is built: the libraries may be installed by this very run.
HOST_CFLAGS = $(eval HOST_CFLAGS := $(or $(shell pkg-config --cflags cairo libedit 2>/dev/null),\
    $(error cairo or libedit is missing: run `make install-deps`)))$(HOST_CFLAGS)
# Their headers only: host/library.h loads them when they are wanted.
HOST_LIBS   = -ldl -lm
# The program itself starts a tenth sooner at a fixed address and with its own copy of the few functions of libm.
START_QUICKLY = -no-pie -ldl -Wl,-Bstatic -lm -Wl,-Bdynamic
TEST_LIBS   = -lcmocka -lmpfr -lgmp -lm

.DEFAULT_GOAL := all
.PHONY: all host demo demo-run test test-run clean help install-deps fuzz asan ubsan valgrind check fmt fmt-check bench sim
all: host ## build everything the desktop needs

host: $(RIDGELINE) ## build the program: build/host/ridgeline

demo: ## install what is missing, build, draw the demo scenes into build/demo
	$(Q)sh .ci/deps.sh host
	+$(Q)$(again) demo-run
demo-run: host
	$(Q)sh host/demo.sh $(RIDGELINE) $(BUILDDIR)/demo

sim: host ## draw SCENE=file.gp: picture and step trace in build/sim
	$(Q)mkdir -p $(BUILDDIR)/sim
	$(Q)$(RIDGELINE) plot '$(SCENE)' -o $(BUILDDIR)/sim/sim.svg -o $(BUILDDIR)/sim/sim.vcd
	$(Q)$(RIDGELINE) trace $(BUILDDIR)/sim/sim.vcd

install-deps: ## install the Debian packages for building, testing and checking
	$(Q)sh .ci/deps.sh host test check

$(BUILDDIR)/libcore.a: $(CORE_OBJ) $(SIM_OBJ)
	$(Q)rm -f $@ && $(AR) rcs $@ $^
$(BUILDDIR)/libhost.a: $(HOST_OBJ)
	$(Q)rm -f $@ && $(AR) rcs $@ $^
$(BUILDDIR)/liboracle.a: $(ORACLE_OBJ)
	$(Q)rm -f $@ && $(AR) rcs $@ $^

$(BUILDDIR)/obj/src/%.o: src/%.c
	@mkdir -p $(@D)
	$(call say,CC,$<)
	$(Q)$(CC) $(CPPFLAGS) $(CFLAGS) $(COREFLAGS) -c $< -o $@
$(BUILDDIR)/obj/host/%.o: host/%.c
	@mkdir -p $(@D)
	$(call say,CC,$<)
	$(Q)$(CC) $(CPPFLAGS) $(CFLAGS) $(HOST_CFLAGS) -c $< -o $@
$(BUILDDIR)/obj/%.o: %.c
	@mkdir -p $(@D)
	$(call say,CC,$<)
	$(Q)$(CC) $(CPPFLAGS) $(CFLAGS) -c $< -o $@

# What hides surfaces lies together, whatever grows elsewhere: its speed depends on how its functions lie to each other.
TOGETHER := $(filter $(BUILDDIR)/obj/src/hidden/surface/%,$(CORE_OBJ))
$(RIDGELINE): $(BUILDDIR)/obj/host/main.o $(TOGETHER) $(BUILDDIR)/libhost.a $(BUILDDIR)/libcore.a
	@mkdir -p $(@D)
	$(call say,LD,$@)
	$(Q)$(CC) $(LDFLAGS) $^ $(BUILDDIR)/libcore.a $(if $(SANITIZE),$(HOST_LIBS),$(START_QUICKLY)) -o $@

$(BUILDDIR)/tests/%: $(BUILDDIR)/obj/tests/%.o $(BUILDDIR)/liboracle.a $(BUILDDIR)/libhost.a $(BUILDDIR)/libcore.a
	@mkdir -p $(@D)
	$(call say,LD,$@)
	$(Q)$(CC) $(LDFLAGS) $^ $(BUILDDIR)/libcore.a $(HOST_LIBS) $(TEST_LIBS) -o $@

# The driver of the boards' console, on a port made for the test.
$(BUILDDIR)/obj/tests/unit/test_uart.o: CPPFLAGS += -Itests/unit/fake_port

# One test program by hand: make run-unit/test_num
.PHONY: $(TESTS_SRC:tests/%.c=run-%)
$(TESTS_SRC:tests/%.c=run-%): run-%: $(BUILDDIR)/tests/%
	$<

RUN_TESTS = RIDGELINE=$(RIDGELINE) BUILDDIR=$(BUILDDIR) JOBS=$(JOBS) sh tests/run.sh

include firmware/firmware.mk tests/emu/emu.mk

test: ## install what is missing, build and run every test; ends with `N passed, N failed`
	$(Q)sh .ci/deps.sh host test firmware emu
	+$(Q)$(again) test-run IMAGES_TOO=1
# IMAGES_TOO=1: the boards' images too, which need packages that the sanitizers' runs do without.
IMAGES_TOO ?=
test-run: host $(TESTS) $(FUZZERS) $(if $(IMAGES_TOO),$(BOARD_NEEDS))
	$(Q)$(RUN_TESTS) $(TESTS) $(CLI_TESTS) $(if $(IMAGES_TOO),$(BOARD_TESTS) .ci/warnings.sh) $(GPIO_RUN) $(FUZZERS)

define test_folder
.PHONY: test-$1
test-$1: host $(filter $(BUILDDIR)/tests/$1/%,$(TESTS)) ## run tests/$1 alone
	$(Q)$(RUN_TESTS) $(filter $(BUILDDIR)/tests/$1/%,$(TESTS))
endef
$(foreach k,$(TEST_KINDS),$(eval $(call test_folder,$k)))
.PHONY: test-cli test-fuzz
test-cli: host ## run tests/cli alone: the program from outside
	$(Q)$(RUN_TESTS) $(CLI_TESTS)
test-fuzz: fuzz

# libFuzzer programs: everything compiled again by clang with coverage, ASan and UBSan.
FUZZ_SECONDS ?= 60
# A tree of calls that only the limit ends would take seconds here: a lower one.
FUZZ_CFLAGS := -std=c11 -g -O1 -MMD -MP -fsanitize=fuzzer-no-link,address,undefined -fno-sanitize-recover=all \
               -DCONFIG_CALL_WORK=10000 -DCONFIG_TURNS=20
FUZZ_OBJ := $(CORE_SRC:%.c=$(BUILDDIR)/fuzz/obj/%.o) $(SIM_SRC:%.c=$(BUILDDIR)/fuzz/obj/%.o)
fuzz: $(FUZZERS) ## run each fuzz target for FUZZ_SECONDS (60)
	$(Q)FUZZ_SECONDS=$(FUZZ_SECONDS) FUZZ_SEED=0 $(RUN_TESTS) $(FUZZERS)
$(BUILDDIR)/fuzz/obj/%.o: %.c
	@mkdir -p $(@D)
	$(call say,FUZZ,$<)
	$(Q)clang $(CPPFLAGS) $(FUZZ_CFLAGS) -c $< -o $@
$(BUILDDIR)/fuzz/libcore.a: $(FUZZ_OBJ)
	$(Q)rm -f $@ && $(AR) rcs $@ $^
$(BUILDDIR)/fuzz/fuzz_%: $(BUILDDIR)/fuzz/obj/tests/fuzz/fuzz_%.o $(BUILDDIR)/fuzz/libcore.a
	$(call say,LD,$@)
	$(Q)clang -fsanitize=fuzzer,address,undefined $^ -lm -o $@

asan: ## every test under AddressSanitizer
	+$(Q)$(again) test-run BUILDDIR=$(BUILDDIR)/asan OPT='-O1 -g' SANITIZE='-fsanitize=address -fno-omit-frame-pointer' FUZZERS=
ubsan: ## every test under UndefinedBehaviorSanitizer
	+$(Q)$(again) test-run BUILDDIR=$(BUILDDIR)/ubsan OPT='-O1 -g' SANITIZE='-fsanitize=undefined -fno-sanitize-recover=all' FUZZERS=
# Not those that only compute: they have no memory to go wrong with, would take minutes, and the reference needs 80-bit
# floating point, which valgrind has not.
VALGRIND_TESTS = $(filter-out %/test_func %/test_func_tables %/test_num %/test_wide %/test_wide_portable %/test_judge %/test_surface_ref,\
    $(filter $(BUILDDIR)/tests/unit/%,$(TESTS)))
valgrind: host $(TESTS) ## the unit tests and the demo scenes under valgrind
	$(Q)sh .ci/valgrind.sh $(RIDGELINE) $(VALGRIND_TESTS)

SOURCES := $(sort $(wildcard src/*.[ch] src/*/*.[ch] src/*/*/*.[ch] sim/*.[ch] host/*.[ch] hal/*.[ch] hal/*/*.[ch] firmware/*.[ch] firmware/tools/*.c tests/*/*.[ch] tests/*/tools/*.[ch]))
check: fmt-check ## both compilers without a warning, static analysis, forbidden symbols on the smallest chip
	$(Q)BUILDDIR=$(BUILDDIR) MAKE=$(MAKE) sh .ci/check.sh
fmt: ## format every source
	$(Q)clang-format -i $(SOURCES)
fmt-check:
	$(Q)clang-format --dry-run -Werror $(SOURCES)

include hal/linux/linux.mk tests/gpio/gpio.mk
-include $(wildcard tests/bench/*.mk tests/report/*.mk tests/cli/*.mk tests/compare/*.mk)

clean: ## remove what was built
	$(Q)rm -rf $(BUILDDIR)
help: ## this list
	@grep -hE '^[a-zA-Z_-]+:.*##' $(MAKEFILE_LIST) | sed -E 's/:[^#]*## /\t/' | expand -t 14
	@printf '%-14s%s\n' test-FOLDER 'run one folder of tests: $(TEST_KINDS) cli fuzz'

.SECONDARY:
-include $(shell find $(BUILDDIR)/obj $(BUILDDIR)/fuzz $(BUILDDIR)/firmware $(BUILDDIR)/emu -name '*.d' 2>/dev/null)
