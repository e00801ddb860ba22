# `make bench-grbl`: the motion of a drawing beside a Grbl's; part of `make bench`.
$(BUILDDIR)/bench/grbl_motion: tests/bench/peers/grbl_motion.c
	@mkdir -p $(@D)
	$(Q)$(CC) $(OPT) -std=c11 $(WARN) -D_DEFAULT_SOURCE $< -lm -o $@

.PHONY: bench-grbl
bench-grbl: host $(BUILDDIR)/bench/grbl_motion ## time and evenness of motion beside a Grbl's, at the same limits
	$(Q)sh tests/bench/grbl.sh $(BUILDDIR)
bench: bench-grbl
