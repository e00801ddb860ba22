# Ridgeline. `make help` lists the targets.
BUILDDIR ?= build
CC       ?= gcc
AR       ?= ar
V        ?= 0
Q        := $(if $(filter 0,$(V)),@,)

WARN     := -Wall -Wextra -Wconversion -Wshadow -Wstrict-prototypes -Wmissing-prototypes
OPT      ?= -O2 -g
CFLAGS   += -std=c11 $(WARN) $(OPT) -MMD -MP
CPPFLAGS += -Isrc -I. -D_DEFAULT_SOURCE
# src/ is integers only: on x86-64 the compiler itself refuses a floating-point instruction there.
COREFLAGS := $(if $(filter x86_64,$(shell uname -m)),-mgeneral-regs-only)

CORE_SRC := $(wildcard src/*.c src/*/*.c)
SIM_SRC  := $(wildcard sim/*.c)
HOST_LIB_SRC := $(filter-out host/main.c,$(wildcard host/*.c))
ORACLE_SRC := $(wildcard tests/oracle/*.c)
TESTS_SRC := $(wildcard tests/unit/test_*.c tests/property/test_*.c tests/hard/test_*.c tests/trace/test_*.c)

CORE_OBJ := $(CORE_SRC:%.c=$(BUILDDIR)/obj/%.o)
SIM_OBJ  := $(SIM_SRC:%.c=$(BUILDDIR)/obj/%.o)
HOST_OBJ := $(HOST_LIB_SRC:%.c=$(BUILDDIR)/obj/%.o)
ORACLE_OBJ := $(ORACLE_SRC:%.c=$(BUILDDIR)/obj/%.o)
TESTS    := $(TESTS_SRC:tests/%.c=$(BUILDDIR)/tests/%)

HOST_CFLAGS = $(shell pkg-config --cflags cairo libedit 2>/dev/null)
HOST_LIBS   = $(shell pkg-config --libs cairo libedit 2>/dev/null) -lm
TEST_LIBS   = -lcmocka -lmpfr -lgmp -lm

.PHONY: all host test clean help
all: host ## build the desktop program

host: $(BUILDDIR)/host/ridgeline ## build/host/ridgeline

$(BUILDDIR)/libcore.a: $(CORE_OBJ) $(SIM_OBJ)
	$(Q)rm -f $@ && $(AR) rcs $@ $^
$(BUILDDIR)/libhost.a: $(HOST_OBJ)
	$(Q)rm -f $@ && $(AR) rcs $@ $^
$(BUILDDIR)/liboracle.a: $(ORACLE_OBJ)
	$(Q)rm -f $@ && $(AR) rcs $@ $^

$(BUILDDIR)/obj/src/%.o: src/%.c
	@mkdir -p $(@D)
	$(Q)$(CC) $(CPPFLAGS) $(CFLAGS) $(COREFLAGS) -c $< -o $@
$(BUILDDIR)/obj/host/%.o: host/%.c
	@mkdir -p $(@D)
	$(Q)$(CC) $(CPPFLAGS) $(CFLAGS) $(HOST_CFLAGS) -c $< -o $@
$(BUILDDIR)/obj/%.o: %.c
	@mkdir -p $(@D)
	$(Q)$(CC) $(CPPFLAGS) $(CFLAGS) -c $< -o $@

$(BUILDDIR)/host/ridgeline: $(BUILDDIR)/obj/host/main.o $(BUILDDIR)/libhost.a $(BUILDDIR)/libcore.a
	@mkdir -p $(@D)
	$(Q)$(CC) $(LDFLAGS) $^ $(BUILDDIR)/libcore.a $(HOST_LIBS) -o $@

$(BUILDDIR)/tests/%: $(BUILDDIR)/obj/tests/%.o $(BUILDDIR)/liboracle.a $(BUILDDIR)/libhost.a $(BUILDDIR)/libcore.a
	@mkdir -p $(@D)
	$(Q)$(CC) $(LDFLAGS) $^ $(BUILDDIR)/libcore.a $(HOST_LIBS) $(TEST_LIBS) -o $@

# One test program by hand: make run-unit/test_num
run-%: $(BUILDDIR)/tests/%
	$<

test: $(TESTS) ## build and run every test
	$(Q)sh tests/run.sh $(TESTS)

clean: ## remove what was built
	$(Q)rm -rf $(BUILDDIR)
help: ## this list
	@grep -hE '^[a-zA-Z_-]+:.*##' $(MAKEFILE_LIST) | sed -E 's/:[^#]*## /\t/' | expand -t 14

.SECONDARY:
-include $(shell find $(BUILDDIR) -name '*.d' 2>/dev/null)
