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

# Every property test with many more seeds: make soak RIDGELINE_CASES=1000.
soak: $(filter $(BUILDDIR)/tests/property/%,$(TESTS)) ## the property tests with RIDGELINE_CASES (100) times as many cases
	$(Q)RIDGELINE_CASES=$(or $(RIDGELINE_CASES),100) $(RUN_TESTS) $^
.PHONY: soak
