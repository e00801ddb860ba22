# boards.mk - what a board is to the compiler: its core, and the capacities (src/config.h) that its memory allows.
BOARDS := rp2040 lm3s6965 nrf51

CPU_rp2040   := -mcpu=cortex-m0plus
CPU_lm3s6965 := -mcpu=cortex-m3
CPU_nrf51    := -mcpu=cortex-m0

OPT_rp2040   := -O2
OPT_lm3s6965 := -Os
# A function that is called once keeps a frame of its own there: 900 bytes of stack less.
OPT_nrf51    := -Os -fno-inline-functions-called-once
# 256 KB of flash are nearly full: fast is what runs for each point, facet, vertex or step, all else is small.
FAST_lm3s6965 := $(wildcard src/motion/*.c src/num/num.c src/num/wide.c src/num/ints.c hal/port/*.c hal/lm3s6965/*.c) \
    src/num/func_trig.c src/num/func_exp.c src/path/simplify.c \
    src/lang/eval.c src/lang/arith.c src/scene/grid.c src/scene/expr_surface.c src/view/chart.c \
    src/view/page_map.c src/view/line_space.c src/view/cut.c src/hidden/envelope.c \
    src/hidden/perimeter.c src/hidden/edges.c src/hidden/sweep.c src/hidden/runs.c
$(FAST_lm3s6965:%.c=$(BUILDDIR)/firmware/lm3s6965/%.o): OPT_lm3s6965 := -O2

CONFIG_rp2040 := CONFIG_LINE_MAX=1024 CONFIG_LOAD_DEPTH=0 CONFIG_READ_CHUNK=16 CONFIG_PLOT_ITEMS=4 CONFIG_DATA_COLUMNS=8 \
    CONFIG_SYMBOLS=64 CONFIG_POOL=2048 CONFIG_STACK=256 CONFIG_CALLS=64 CONFIG_PLOT_CODE=1024 CONFIG_JOINS=8 CONFIG_NAME_MAX=80 \
    CONFIG_JOURNAL=1024 CONFIG_STEP_RATE=24000 CONFIG_BOARD_BYTES=212992 CONFIG_MOTION_BLOCKS=512 CONFIG_MOTION_PIECES=64
CONFIG_lm3s6965 := CONFIG_AREA=0 CONFIG_LINE_MAX=512 CONFIG_LOAD_DEPTH=0 CONFIG_READ_CHUNK=16 CONFIG_PLOT_ITEMS=2 CONFIG_DATA_COLUMNS=8 \
    CONFIG_SYMBOLS=32 CONFIG_POOL=1024 CONFIG_STACK=64 CONFIG_CALLS=16 CONFIG_PLOT_CODE=512 CONFIG_JOINS=4 CONFIG_NAME_MAX=64 \
    CONFIG_TYPED=128 CONFIG_JOURNAL=256 CONFIG_STEP_RATE=25000 CONFIG_BOARD_BYTES=36864 CONFIG_MOTION_BLOCKS=128 CONFIG_MOTION_PIECES=32 CONFIG_PULSE_NS=4000
CONFIG_nrf51 := CONFIG_SOLIDS=0 CONFIG_LINE_MAX=128 CONFIG_LOAD_DEPTH=0 CONFIG_READ_CHUNK=16 CONFIG_PLOT_ITEMS=1 CONFIG_DATA_COLUMNS=4 \
    CONFIG_SYMBOLS=12 CONFIG_POOL=256 CONFIG_STACK=24 CONFIG_CALLS=4 CONFIG_PLOT_CODE=128 CONFIG_JOINS=1 CONFIG_NAME_MAX=16 \
    CONFIG_NESTING=16 CONFIG_TYPED=32 CONFIG_JOURNAL=32 CONFIG_BOARD_BYTES=5360 CONFIG_MOTION_BLOCKS=16 CONFIG_MOTION_PIECES=8 \
    CONFIG_STEP_RATE=5000 CONFIG_SPEED_UM_S=60000 CONFIG_PULSE_NS=10000 CONFIG_DIR_SETUP_NS=5000
