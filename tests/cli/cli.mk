# A person at a terminal, for tests/cli/test_prompt.sh: build/tools/terminal.
$(BUILDDIR)/tools/terminal: $(BUILDDIR)/obj/tests/cli/tools/terminal.o
	@mkdir -p $(@D)
	$(call say,LD,$@)
	$(Q)$(CC) $(LDFLAGS) $^ -o $@
test-run test-cli: $(BUILDDIR)/tools/terminal
