# The judges of finished drawings as programs: build/tools/judge_seg of surfaces, judge_solid of solids.
JUDGES := $(BUILDDIR)/tools/judge_seg $(BUILDDIR)/tools/judge_solid
JUDGE_SRC := $(wildcard tests/oracle/tools/*.c)
$(JUDGES): $(BUILDDIR)/tools/%: $(JUDGE_SRC:%.c=$(BUILDDIR)/obj/%.o) $(BUILDDIR)/liboracle.a
	@mkdir -p $(@D)
	$(call say,LD,$@)
	$(Q)$(CC) $(LDFLAGS) $(filter-out %/judge_seg.o %/judge_solid.o,$(filter %.o,$^)) $(BUILDDIR)/obj/tests/oracle/tools/$*.o $(BUILDDIR)/liboracle.a -lgmp -lm -o $@
# tests/cli/test_judged.sh and test_solids.sh run them.
test-run test-cli: $(JUDGES)
judge: $(JUDGES) ## build the judges of drawings: build/tools/judge_seg and judge_solid
.PHONY: judge
