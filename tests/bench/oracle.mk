# The judge of finished drawings as a program: build/tools/judge_seg.
JUDGE_SRC := $(wildcard tests/oracle/tools/*.c)
$(BUILDDIR)/tools/judge_seg: $(JUDGE_SRC:%.c=$(BUILDDIR)/obj/%.o) $(BUILDDIR)/liboracle.a
	@mkdir -p $(@D)
	$(call say,LD,$@)
	$(Q)$(CC) $(LDFLAGS) $^ -lgmp -lm -o $@
# tests/cli/test_judged.sh runs it.
test-run test-cli: $(BUILDDIR)/tools/judge_seg
judge: $(BUILDDIR)/tools/judge_seg ## build the judge of drawings: build/tools/judge_seg
.PHONY: judge
