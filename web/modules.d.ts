declare module '#network.bin?url' {
  const url: string;
  export default url;
}

declare module '#core.wasm?url' {
  const url: string;
  export default url;
}
