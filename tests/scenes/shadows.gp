# A temple in the afternoon sun: visible polygons, the shadows they cast, and hatching by their slope to the light.
set view from 26,-24,13 to 0,0,3
set hidden3d area
set light 4,-14,13
set shadow on
set hatch 62,1
splot 'temple.obj'
