# The language beside gnuplot's: build/tools/compare_gnuplot; part of `make test` (tests/cli/test_compare.sh), longer by
# `make compare-gnuplot`.
COMPARE_OBJ := $(patsubst %.c,$(BUILDDIR)/obj/%.o,$(wildcard tests/compare/*.c))
SEED        ?= 1
EXPRESSIONS ?= 10000
SCRIPTS     ?= 3000
.PHONY: compare-gnuplot
$(BUILDDIR)/tools/compare_gnuplot: $(COMPARE_OBJ)
	@mkdir -p $(@D)
	$(call say,LD,$@)
	$(Q)$(CC) $(LDFLAGS) $^ -lm -o $@
test-run test-cli: $(BUILDDIR)/tools/compare_gnuplot
compare-gnuplot: host $(BUILDDIR)/tools/compare_gnuplot ## random expressions and scripts, typed to gnuplot and to ridgeline (SEED=1 EXPRESSIONS=10000 SCRIPTS=3000)
	$(Q)sh tests/compare/compare.sh $(BUILDDIR)/tools/compare_gnuplot $(RIDGELINE) $(SEED) $(EXPRESSIONS) $(SCRIPTS)
