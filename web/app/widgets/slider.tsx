interface SliderProps {
  label: string;
  value: number;
  min: number;
  max: number;
  step: number;
  onInput(value: number): void;
}

export function Slider({ label, value, min, max, step, onInput }: SliderProps) {
  return (
    <label class="slider">
      <span>{label}</span>
      <input
        type="range"
        min={min}
        max={max}
        step={step}
        value={value}
        onInput={(event) => onInput(Number(event.currentTarget.value))}
      />
      <output>{Number(value.toPrecision(3))}</output>
    </label>
  );
}
