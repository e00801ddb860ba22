# boards.mk - what a board is to the compiler: its core, and the capacities (src/config.h) that its memory allows.
BOARDS := rp2040 lm3s6965 nrf51

CPU_rp2040   := -mcpu=cortex-m0plus
CPU_lm3s6965 := -mcpu=cortex-m3
CPU_nrf51    := -mcpu=cortex-m0

OPT_rp2040   := -O2
OPT_lm3s6965 := -Os -flto=auto
# A function that is called once keeps a frame of its own there: 900 bytes of stack less.
# What is taken out of loops needs registers that there are not: 1.2 KB of flash less, a quarter of a percent slower.
OPT_nrf51    := -Os -flto=auto -fno-inline-functions-called-once -fno-tree-loop-im -fno-move-loop-invariants -flive-range-shrinkage
# 256 KB of flash hold every system but the area sort. Fast is what runs for each step; all else is small.
FAST_lm3s6965 := $(filter-out $(addprefix src/motion/,motion.c machine.c planner.c kinematics.c),$(wildcard src/motion/*.c)) $(wildcard hal/port/*.c hal/lm3s6965/*.c) src/num/wide.c src/num/ints.c src/num/num.c
$(FAST_lm3s6965:%.c=$(BUILDDIR)/firmware/lm3s6965/%.o): OPT_lm3s6965 := -O2

CONFIG_rp2040 := CONFIG_LINE_MAX=1024 CONFIG_LOAD_DEPTH=0 CONFIG_READ_CHUNK=16 CONFIG_PLOT_ITEMS=4 CONFIG_DATA_COLUMNS=8 \
    CONFIG_SYMBOLS=64 CONFIG_POOL=2048 CONFIG_STACK=256 CONFIG_CALLS=64 CONFIG_PLOT_CODE=1024 CONFIG_JOINS=8 CONFIG_NAME_MAX=80 \
    CONFIG_JOURNAL=1024 CONFIG_STEP_RATE=200000 CONFIG_OUTBOX=96 CONFIG_BOARD_BYTES=212992 CONFIG_MOTION_BLOCKS=512 CONFIG_MOTION_PIECES=64
CONFIG_lm3s6965 := HAL_STORE_BYTES=2048u CONFIG_AREA=0 CONFIG_DOUBLES=1 CONFIG_LINE_MAX=512 CONFIG_LOAD_DEPTH=0 CONFIG_READ_CHUNK=16 CONFIG_PLOT_ITEMS=2 CONFIG_DATA_COLUMNS=8 \
    CONFIG_SYMBOLS=32 CONFIG_POOL=1024 CONFIG_STACK=64 CONFIG_CALLS=16 CONFIG_PLOT_CODE=512 CONFIG_JOINS=4 CONFIG_NAME_MAX=64 \
    CONFIG_TYPED=128 CONFIG_JOURNAL=256 CONFIG_STEP_RATE=50000 CONFIG_OUTBOX=32 CONFIG_ORDER_US=2500 CONFIG_BOARD_BYTES=36864 CONFIG_MOTION_BLOCKS=128 CONFIG_MOTION_PIECES=32 CONFIG_PULSE_NS=4000
CONFIG_nrf51 := HAL_STORE_BYTES=2048u CONFIG_AREA=0 CONFIG_LINE_MAX=128 CONFIG_LOAD_DEPTH=0 CONFIG_READ_CHUNK=16 CONFIG_PLOT_ITEMS=1 CONFIG_DATA_COLUMNS=4 \
    CONFIG_SYMBOLS=12 CONFIG_POOL=256 CONFIG_STACK=24 CONFIG_CALLS=4 CONFIG_PLOT_CODE=128 CONFIG_JOINS=1 CONFIG_NAME_MAX=16 \
    CONFIG_NESTING=16 CONFIG_TYPED=32 CONFIG_JOURNAL=32 CONFIG_WAITING=4 CONFIG_BOARD_BYTES=5256 CONFIG_MOTION_BLOCKS=16 CONFIG_MOTION_PIECES=8 \
    CONFIG_STEP_RATE=20000 CONFIG_STEP_ACCEL=240000 CONFIG_PULSE_NS=10000 CONFIG_DIR_SETUP_NS=5000
# A Cortex-M0 does not divide.
CONFIG_rp2040 += CONFIG_DIVIDES=0
CONFIG_nrf51 += CONFIG_DIVIDES=0
# A servo is the Pico's.
CONFIG_lm3s6965 += CONFIG_PEN_SERVO=0
CONFIG_nrf51 += CONFIG_PEN_SERVO=0 CONFIG_FED=0 CONFIG_ROW_POINTS=1
# UNSET=CONFIG_STEP_RATE (with a BUILDDIR of its own): what the boards refuse otherwise (make bench-rates).
UNSET ?=
