/** What the page says of drawing, for the catalogue. */

export const strokeEnglish = {
  hintDraw: 'Closed: a part. Open, from a part and back: a limb. A line: a tube. Small or tapped on a part: a detail. Shift: behind all.',
  dotOnPaper: 'A tap makes a detail of the part below, but here is none. Draw a shape.',
  nothingToJoin: 'This part lies on no other that it could be joined to.',
  plainGraphics: 'This browser shows no 3D graphics, so the relief is drawn more slowly and plainly. Exports are the same.',
  color: 'Colour',
  otherColor: 'Another colour',
  light: 'Light',
  hintLight: 'Dragging on the relief moves the light.',
  peek: 'Peek',
  hintPeek: 'The page leans into depth and follows the pointer.',
  showLarge: '{name}: show large',
  behind: 'Behind',
  hintBehind: 'What is drawn next lies behind all parts.',
  joinOffer: 'Join with {name}',
  paperStroke: 'Here is nothing but paper. Begin on the figure, or choose Outside.',
};

export const strokeGerman: Record<keyof typeof strokeEnglish, string> = {
  hintDraw: 'Geschlossen: ein Teil. Offen, von einem Teil aus und zurück: ein Glied. Eine Linie: ein Rohr. Klein oder getippt auf einem Teil: eine Einzelheit. Umschalt: hinter alles.',
  dotOnPaper: 'Tippen macht eine Einzelheit des Teils darunter, doch hier ist keines. Zeichne eine Form.',
  nothingToJoin: 'Dieses Teil liegt auf keinem, mit dem es sich verbinden ließe.',
  plainGraphics: 'Dieser Browser zeigt keine 3D-Grafik; das Relief wird langsamer und schlichter gezeichnet. Ausgaben sind dieselben.',
  color: 'Farbe',
  otherColor: 'Eine andere Farbe',
  light: 'Licht',
  hintLight: 'Ziehen auf dem Relief bewegt das Licht.',
  peek: 'Tiefe',
  hintPeek: 'Das Blatt neigt sich in die Tiefe und folgt dem Zeiger.',
  showLarge: '{name} groß zeigen',
  behind: 'Dahinter',
  hintBehind: 'Was als Nächstes gezeichnet wird, liegt hinter allen Teilen.',
  joinOffer: 'Mit {name} verbinden',
  paperStroke: 'Hier ist nur Papier. Beginne auf der Figur oder wähle Außen.',
};
