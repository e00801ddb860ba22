# `make bench-num`: what an arithmetic operation and a function cost.
$(BUILDDIR)/bench/bench_num: $(BUILDDIR)/obj/tests/bench/bench_num.o $(BUILDDIR)/libcore.a
	@mkdir -p $(@D)
	$(call say,LD,$@)
	$(Q)$(CC) $(LDFLAGS) $^ -lm -o $@
bench-num: $(BUILDDIR)/bench/bench_num ## ns per operation of src/num beside libm's double
	$(Q)$<
.PHONY: bench-num
