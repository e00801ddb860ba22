# gpio.mk - the emulated gpiochip, and the test that runs ridgeline-gpio of both libgpiod versions against it.
GPIO_TESTS := $(wildcard tests/gpio/test_*.sh)
GPIO_EMU   := $(BUILDDIR)/gpio/libgpioemu.so $(BUILDDIR)/gpio/emu_tool $(BUILDDIR)/gpio/emu_judge
GPIO_HEADERS := $(wildcard tests/gpio/*.h)
GPIO_CFLAGS := $(CPPFLAGS) -std=c11 $(WARN) -O2

$(BUILDDIR)/gpio/libgpioemu.so: tests/gpio/emu_preload.c tests/gpio/emu_uapi.c tests/gpio/emu.c $(GPIO_HEADERS)
	@mkdir -p $(@D)
	$(call say,LD,$@)
	$(Q)$(CC) $(GPIO_CFLAGS) -fPIC -shared $(filter %.c,$^) -ldl -o $@
$(BUILDDIR)/gpio/emu_tool: tests/gpio/emu_tool.c tests/gpio/emu.c $(GPIO_HEADERS)
	@mkdir -p $(@D)
	$(call say,LD,$@)
	$(Q)$(CC) $(GPIO_CFLAGS) $(filter %.c,$^) -o $@
$(BUILDDIR)/gpio/emu_judge: tests/gpio/emu_judge.c tests/gpio/emu.c $(BUILDDIR)/libhost.a $(BUILDDIR)/libcore.a $(GPIO_HEADERS)
	@mkdir -p $(@D)
	$(call say,LD,$@)
	$(Q)$(CC) $(GPIO_CFLAGS) $(LDFLAGS) $(filter %.c %.a,$^) $(BUILDDIR)/libhost.a $(HOST_LIBS) -o $@

# ridgeline-gpio with libgpiod 2.x too, where its packages can be had.
GPIO2 := $(BUILDDIR)/gpio/v2/ridgeline-gpio
.PHONY: gpio-v2
gpio-v2: $(BUILDDIR)/libhost.a $(BUILDDIR)/libsrc.a
	@mkdir -p $(BUILDDIR)/gpio
	$(Q)if sh tests/gpio/get_v2.sh $(BUILDDIR)/gpio/debian-v2 >$(BUILDDIR)/gpio/get_v2.log 2>&1; then \
	    . $(BUILDDIR)/gpio/debian-v2/env && $(MAKE) --no-print-directory gpio GPIO=$(GPIO2); \
	else echo "libgpiod 2.x cannot be had: tests run with $(GPIO_VERSION) alone"; fi

.PHONY: test-gpio gpio-ready
gpio-ready: host $(GPIO_EMU) gpio-v2
test-gpio: gpio-ready ## run tests/gpio alone: ridgeline-gpio on an emulated gpiochip
	$(Q)$(RUN_TESTS) $(GPIO_TESTS)
# Not under a sanitizer: its runtime wants to be the first library, and so does the emulation.
ifneq ($(GPIO_API),)
ifeq ($(SANITIZE),)
test-run: gpio-ready
GPIO_RUN := $(GPIO_TESTS)
endif
endif

# The emulation's truth check: the same programs on the kernel's own gpio-sim. Its kernel takes minutes to build, once, so it is not
# part of `make test`.
.PHONY: check-uml check-uml-run
check-uml: ## install what is missing, run ridgeline-gpio on gpio-sim of a user-mode Linux: at most 40 minutes, usually 3, then 1
	$(Q)sh .ci/deps.sh host test uml
	+$(Q)$(again) check-uml-run
check-uml-run: gpio-ready
	$(Q)JOBS=$(JOBS) timeout 1800 sh tests/gpio/uml_build.sh $(BUILDDIR)/gpio/uml
	$(Q)$(RUN_TESTS) tests/gpio/uml.sh
