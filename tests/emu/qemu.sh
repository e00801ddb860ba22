# qemu.sh - how QEMU is made into one of the boards that it can be; for lib.sh and try.sh.
#
#     qemu BOARD BUILD STORE ARGUMENTS    runs its image with the plugin scope.so, which is given ARGUMENTS as well; STORE is the part of the flash
#                                         that settings are kept in, and is made erased if it is not there
# run_by="timeout 300": what the command is given to; serial: where the console goes; more: options; turned="pen enable": pins with
# levels turned round.

# What QEMU 7.2 says of every program on these boards, and nothing else, is let pass: it looks for a vector table before one
# is loaded; a timer of its own has no clock yet; with -d unimp, of the nRF51's clock and watchdog.
QEMU_SAYS="Invalid read at addr 0x[04], size 4, region '[(]null[)]', reason: rejected|^clock_(read|write): 0x"
QEMU_SAYS="$QEMU_SAYS|^nrf51_soc.io: unimplemented device write [(]size 4, offset 0x00010|^Timer with period zero, disabling"

low() { # pin
    case " $turned " in *" $1 "*) echo :low ;; esac
}

qemu() { # board, build, store, further arguments
    wires=
    case $1 in
    lm3s6965)
        # 16 ns an instruction: 62 million a second on a 50 MHz chip. No sleeping: see hal_idle of the port.
        machine=lm3s6965evb shift=4 kept=0x3e000 gpio=/machine/unattached/device wires=,stellaris=1
        pins='x_step@0 x_dir@1 y_step@2 y_dir@3 pen@4 enable@5' out='[9]'
        inputs='limit_x@0 limit_y@1 button@2 estop@3' in='[12]'
        ;;
    nrf51)
        machine=microbit shift=6 kept=0x3e000 gpio=/machine/nrf51 out= in=
        pins='x_step@3 x_dir@2 y_step@1 y_dir@18 pen@20 enable@16'
        inputs='limit_x@23 limit_y@22 button@17 estop@21'
        ;;
    esac
    for n in $pins; do wires=$wires,pin=${n%@*}:$gpio$out@${n#*@}$(low ${n%@*}); done
    for n in $inputs; do wires=$wires,input=${n%@*}:$gpio$in@${n#*@}:low; done
    [ -e "$3" ] || head -c 8192 /dev/zero | LC_ALL=C tr '\0' '\377' >"$3"
    # shellcheck disable=SC2086
    $run_by qemu-system-arm -M $machine -display none -monitor none -serial "$serial" -icount "shift=$shift,align=off,sleep=off" \
        -d guest_errors $more -device "loader,file=$3,addr=$kept,force-raw=on" \
        -plugin "$2/emu/scope.so,$4$wires,store=$3,flash=$kept+0x2000" -kernel "$2/firmware/$1.elf"
}
