# A surface and solids with the shadows of two lights: silhouettes, tones, borders of shadows and what is behind glass have pens
# of their own, in the house's walls there are doors and windows, and there is a jar in the greenhouse.
set title "Dunes, two lights and four pens"
set hidden3d area outline
set crease 40
set hatch 62,1
set shadow outline
set light 1 3,-7,6
set light 2 -8,-3,5
set pen hatch 8 shadow 3 hidden 4
set isosamples 30
set view from 9.5,-13.5,9 to 0.1,-0.3,0.9
splot [-4.5:4.5][-4.5:4.5] 0.3*sin(0.9*x)*cos(0.8*y), 'dunes.obj', 'glass.obj' translucent, \
    'glass.obj' scale 0.3,0.3,0.6 translate 1.82,-1.54,0.2
