# linux.mk - ridgeline-gpio, the program that steps a machine on gpio lines, against the libgpiod that pkg-config finds.
# GPIO_PKG_CONFIG finds another one, and GPIO says which program is built with it.
GPIO_PKG_CONFIG ?= pkg-config
GPIO        ?= $(BUILDDIR)/host/ridgeline-gpio
GPIO_VERSION := $(shell $(GPIO_PKG_CONFIG) --modversion libgpiod 2>/dev/null)
GPIO_API    := $(firstword $(subst ., ,$(GPIO_VERSION)))
GPIO_SRC    := $(filter-out hal/linux/lines_v%.c,$(wildcard hal/linux/*.c))
GPIO_OBJ    := $(GPIO_SRC:%.c=$(BUILDDIR)/obj/%.o)
GPIO_LINES  := $(GPIO).d/lines.o

.PHONY: gpio
ifeq ($(GPIO_API),)
gpio: ## build ridgeline-gpio, for the gpio lines of this board: needs libgpiod
	@echo "libgpiod is missing: install libgpiod-dev"; false
else
gpio: $(GPIO)
host: $(GPIO)
endif

# Linked with src/ alone: a hal function that hal/linux has not must not come from the simulator.
$(BUILDDIR)/libsrc.a: $(CORE_OBJ)
	$(Q)rm -f $@ && $(AR) rcs $@ $^
$(GPIO_LINES): hal/linux/lines_v$(GPIO_API).c hal/linux/lines.h
	@mkdir -p $(@D)
	$(call say,CC,$<)
	$(Q)$(CC) $(CPPFLAGS) $(CFLAGS) $(shell $(GPIO_PKG_CONFIG) --cflags libgpiod) -c $< -o $@
$(GPIO): $(GPIO_OBJ) $(GPIO_LINES) $(BUILDDIR)/libhost.a $(BUILDDIR)/libsrc.a
	@mkdir -p $(@D)
	$(call say,LD,$@)
	$(Q)$(CC) $(LDFLAGS) $^ $(BUILDDIR)/libhost.a $(shell $(GPIO_PKG_CONFIG) --libs libgpiod) $(GPIO_LDFLAGS) -lm -o $@
