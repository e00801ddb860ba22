# power.sh - what is kept without power; for the tests of the boards, after lib.sh.
within=0.8
[ $board = nrf51 ] && within=2
scene keep $within 9
says '^saved'
again button $within
says '^> start'
again autorun_on $within 9
again autorun $within
says '^autorun'
scene save_drawing $within 9
says '^saved'
again autorun $within
says '^autorun'
