var ll=class{#e;#t=new Map;#n=[];#i=!1;constructor(t){this.#e=t}shownIn(t,e){this.#n.push(e),this.#t.set(t,!1),new IntersectionObserver(n=>{this.#t.set(t,n[n.length-1].isIntersecting),this.#s()}).observe(t)}#s(){let t=[...this.#t.values()].includes(!0);if(t===this.#i)return;this.#i=t;let e=(n,s)=>this.#n.forEach(r=>r(n,s));this.#e.sampleActivity(t?e:null)}};var bt=i=>document.getElementById(i),C=(i,t,...e)=>mp(document.createElement(i),t,e),Sn=(i,t,...e)=>mp(document.createElementNS("http://www.w3.org/2000/svg",i),t,e);function mp(i,t,e){for(let[n,s]of Object.entries(t))typeof s=="function"?i.addEventListener(n.slice(2),s):s===!0?i.setAttribute(n,""):s!==!1&&s!=null&&i.setAttribute(n,String(s));return i.append(...e.filter(n=>n!=null)),i}var ji=i=>i.getContext("2d");function cl(i,t){let e=new Set(t);for(let n of[...i.children])e.has(n)||n.remove();t.forEach((n,s)=>{let r=i.children[s];r!==n&&i.insertBefore(n,r??null)})}var $t=(i,t=300)=>i.length>t?`${i.slice(0,t)} \u2026 (${i.length} characters)`:i,hl=(i,t)=>(Number(i.toFixed(t))+0).toFixed(t),We=i=>new Date(i/1e3).toLocaleTimeString("en-GB",{hour12:!1}),Te=i=>$t(i.said??i.sentence??String(i),1600);function ii(i){let t=!1;return()=>{t||(t=!0,requestAnimationFrame(()=>{t=!1,i()}))}}var ul=class{#e={};#t=[];set(t){this.#e=t;for(let e of this.#t)e()}onChange(t){this.#t.push(t)}words(t,e,n=1){let s=this.#e[t]??[];return e.map((r,o)=>{let[a,l]=s[o]??[`axis ${o+1}`,""];return[a,`${hl(r,n)} ${l}`.trim()]})}};var Yo=class{constructor(t){this.name=t}toString(){return this.name}},zt=i=>new Yo(i),Y=i=>i instanceof Yo?i.name:typeof i=="string"?i:"",gp=/\s*(?:;[^\n]*\n\s*)*(\(|\)|"(?:[^"\\]|\\.)*"|[^\s()";]+)/y,kx={n:`
`,t:"	"};function zx(i){return i[0]==='"'?i.slice(1,-1).replace(/\\(.)/gs,(t,e)=>kx[e]??e):/^[-+]?\d/.test(i)?Number(i):new Yo(i)}function si(i){gp.lastIndex=0;let t=[[]];for(;;){let e=gp.exec(i);if(!e)break;if(e[1]==="(")t.push([]);else if(e[1]===")"){let n=t.pop();if(t.length===0)return[];t[t.length-1].push(n)}else t[t.length-1].push(zx(e[1]))}return t[0][0]??[]}var Vx=i=>`"${i.replace(/[\\"]/g,"\\$&").replace(/\n/g,"\\n").replace(/\t/g,"\\t").replace(/[\0-\x08\x0b-\x1f]/g," ")}"`;function te(i){return Array.isArray(i)?`(${i.map(te).join(" ")})`:typeof i=="string"?Vx(i):String(i)}var fl=class{#e;#t=null;#n=null;#i=null;constructor(t){this.#e=t}open(){this.#t&&this.#e.say(zt("truth")),this.#n&&this.#e.say(zt("activity")),this.#i&&this.#e.say(zt("work"),this.#e.number())}hear(t){"truth"in t?this.#t?.(t.truth===null?null:si(t.truth),t.said):"activity"in t?this.#n?.(t.activity,t.said):this.#i?.(t.work,t.changes)}layTruth(t){this.#t=t,this.#e.say(zt(t?"truth":"truth-no-more"))}sampleActivity(t){this.#n=t,this.#e.say(zt(t?"activity":"activity-no-more"))}earlierWork(t){this.#i=t,this.#e.say(zt("work"),this.#e.number())}};var dl=class{#e;#t;#n;#i=0;stamp=0;constructor(t,e,n){this.#e=t,this.#t=e,this.#n=n}jog(t,e){this.#i=this.#e.number();let n=[zt(t),zt(e),this.stamp];return this.#s("jog",...n),this.#t.callAs(this.#i,null,"jog",...n)}holdOn(){this.#e.say(zt("hold-on"),this.#i,this.stamp),this.#s("hold-on",this.stamp)}release(){this.#e.say(zt("release"),this.#i),this.#s("release")}stop(t){let e=this.#e.number();return this.#n.say(te([zt("stop"),e,t])),this.#t.callAs(e,null,"stop",t)}#s(t,...e){this.#n.say(te([zt(t),this.#i,...e]))}};var Gx=1e3,bu=i=>{let t=new WebSocket(`${location.protocol.replace("http","ws")}//${location.host}${i}`);return t.binaryType="arraybuffer",t},pl=class{#e;#t=new Set;constructor(t){this.#e=t}open({path:t,lanes:e}){this.close();for(let n=0;n<e;++n)this.#n(t)}close(){let t=this.#t;this.#t=new Set;for(let e of t)e.close()}say(t){[...this.#t].find(({readyState:n})=>n===WebSocket.OPEN)?.send(t)}#n(t){let e=this.#t,n=bu(t);e.add(n),n.onmessage=async({data:s})=>{let r=performance.now();await this.#e(s),n.send(te([zt("drawn"),Math.round(performance.now()-r)]))},n.onclose=()=>{e.delete(n),setTimeout(()=>e===this.#t&&this.#n(t),Gx)}}};var Hx=5e6;async function wu(i){let t=new Uint8Array(i),e=t.indexOf(10),[,n,s,r,o,a]=si(new TextDecoder().decode(t.subarray(0,e))),l=new Blob([t.subarray(e+1)],{type:"image/jpeg"}),c=await createImageBitmap(l).catch(()=>null);return[n,c&&{bitmap:c,number:s,captured:r,width:o,height:a}]}var ml=class{#e;#t=new Map;#n=new Map;lanes=new pl(t=>this.#i(t));constructor(t){this.#e=t}open(t){this.lanes.open(t);for(let e of this.#t.keys())this.#e.say(zt("look"),zt(e))}lost(){this.lanes.close()}add(t,e){return this.#t.set(t,e),this.#e.say(zt("look"),zt(t)),()=>{this.#t.delete(t),this.#e.say(zt("look-away"),zt(t))}}async#i(t){let[e,n]=await wu(t);if(await new Promise(requestAnimationFrame),!n)return;let{captured:s}=n,r=this.#n.get(Y(e))??0;(s>=r||r-s>Hx)&&(this.#n.set(Y(e),s),this.#t.get(Y(e))?.(n)),n.bitmap.close()}};var gl=class{#e=new Map;#t;constructor(t){this.#t=t}change(t){t.resynchronised&&this.#e.clear();for(let e of t.removed)this.#e.delete(e.join());for(let e of t.added)this.#e.set(e.ids.join(),e);this.#t([...this.#e.values()],t)}};function ht(i){return i.read??=si(i.facts[0].text),i.read}var Wx=4,_l=class{#e;#t=new Map;#n=new Map;#i=new Map;moment=null;constructor(t){this.#e=t}open(){for(let[t,e]of this.#t)this.#s(t,e)}lost(){for(let t of this.#i.values())t({error:this.#e.notConnected});this.#i.clear()}hear(t){let e=this.#t.get(t.watch);(t.past??null)===(e?.always?null:this.moment)&&e?.take(t),t.past&&this.#i.get(t.watch)?.(t)}refused(t,e){this.#i.get(t)?.(e),this.#t.get(t)?.take(e)}#s(t,e){e.once?this.#e.say(zt("ask"),t,si(e.query)):e.typed?this.#e.say(zt("watch"),t,e.query):this.#e.say(zt("follow"),t,si(e.query))}#r(t,e,n,s,r=!1){let o=this.#e.number(),a=new gl(n),l={query:t,typed:e,always:r,take:c=>"error"in c?s(c.error):a.change(c)};return this.#t.set(o,l),this.#s(o,l),()=>{this.#t.delete(o),this.#e.say(zt("unwatch"),o)}}follow(t,e,n=!1){let s=`${n} ${t}`,r=this.#n.get(s)??{listeners:[],told:null};if(r.listeners.push(e),r.told&&e(...r.told),this.#n.has(s))return;this.#n.set(s,r);let o=(...a)=>{r.told=a;for(let l of r.listeners)l(...a)};this.#r(t,!1,o,()=>{},n)}watch(t,e,n){return this.#r(t,!0,e,n)}ask(t){let e=this.#e.number();return new Promise(n=>{let s=o=>{this.#t.delete(e),n("error"in o?[]:o.added)},r={query:te(t),once:!0,take:s,always:!0};this.#t.set(e,r),this.#s(e,r)})}async askThen(t,e){let n=this.#e.number(),s=await this.#a(n,t,e);if(this.#i.delete(n),"error"in s)throw s.error;return s.added}async showMoment(t){this.moment=t;let e=[...this.#t].filter(([,n])=>!n.always);if(t!==null)return this.#o(e,t);for(let[n,s]of e)this.#e.say(zt("unwatch"),n),this.#s(n,s);return null}async#o(t,e){let n=null,s=async()=>{for(let r=t.shift();r&&this.moment===e;r=t.shift()){let[o,a]=r,l=await this.#a(o,a.query,e);if(!("error"in l))continue;l.error.symbol==="undeclared-relation"?a.take({resynchronised:!0,cut:0,removed:[],added:[]}):n??=l.error}};return await Promise.all(Array.from({length:Wx},s)),n}#a(t,e,n){return new Promise(s=>{this.#i.set(t,s),this.#e.say(zt("then"),t,si(e),n)||s({error:this.#e.notConnected})})}};var Xx={symbol:"unreachable",sentence:"the console has gone; whether it was done is not known"},xl=class{#e;#t=new Map;constructor(t){this.#e=t}lost(){for(let{reject:t}of this.#t.values())t(Xx);this.#t.clear()}hear(t,e){this.#t.get(t)?.take(e)}call(t,...e){return this.callAs(this.#e.number(),null,t,...e)}callWith(t,e,...n){return this.callAs(this.#e.number(),t,e,...n)}callAs(t,e,n,...s){return new Promise((r,o)=>{let a=l=>{e&&!("error"in l)?this.#t.set(t,{reject:()=>{},take:c=>this.#n(t,e,c)}):this.#t.delete(t),"error"in l?o(l.error):r(l.values)};this.#t.set(t,{reject:o,take:a}),!this.#e.say(zt(n),t,...s)&&(this.#t.delete(t),o(this.#e.notConnected))})}#n(t,e,n){this.#t.delete(t),e(n)}};var yl=class{#e;#t;#n=0;#i=!1;constructor(t){this.#e=t}begin(){this.end(),this.#i=!1,this.#n=performance.now(),this.#t=setInterval(()=>this.#s(),250)}end(){clearInterval(this.#t)}heard(){this.#n=performance.now(),this.#i&&this.#s()}#s(){let t=performance.now()-this.#n,e=this.#i;this.#i=t>2500,this.#i?this.#e("silent",`for ${Math.floor(t/1e3)} s`):e&&this.#e("live")}};var _p=500,qx=4e3,$x=5,vl=class{#e=null;#t=1;#n=_p;#i=0;#s={say:(...t)=>this.#u(...t),number:()=>this.#t++,notConnected:{symbol:"unreachable",sentence:"the console is not connected"}};#r=new _l(this.#s);#o=new xl(this.#s);#a=new ml(this.#s);#l=new dl(this.#s,this.#o,this.#a.lanes);#c=new fl(this.#s);#h=new yl((t,e)=>this.onState(t,e));onState=()=>{};onHello=()=>{};onArm=()=>{};onPulse=()=>{};async open(){let t=location.hash.slice(1);t&&history.replaceState(null,"",location.pathname),await this.logIn(t)}async logIn(t){t&&await fetch("/session",{method:"POST",headers:{Authorization:`Bearer ${t}`}}).catch(()=>null),this.#f()}async logOut(){await fetch("/socket",{method:"DELETE"}).catch(()=>null),location.reload()}#f(){this.onState("connecting");let t=bu("/socket");t.onmessage=e=>typeof e.data=="string"?this.#p(JSON.parse(e.data)):this.#m(e.data),t.onclose=({reason:e})=>this.#d(e),this.#e=t}async#d(t){this.#e=null,this.#i=0,this.#l.stamp=0,this.#h.end();for(let n of[this.#a,this.#r,this.#o])n.lost();let e=await fetch("/socket").catch(()=>null);if(e?.status===403)return this.onState("refused",t);this.onState("lost",e?.status===503?(await e.text()).trim():t),setTimeout(()=>this.#f(),this.#n),this.#n=Math.min(this.#n*2,qx)}#u(...t){return this.#e?.readyState!==WebSocket.OPEN?!1:(this.#e.send(te(t)),!0)}#p(t){"error"in t&&(t.error.said=t.said),"hello"in t?this.#_(t.hello):"pulse"in t?this.#g(t):"reply"in t?(this.#o.hear(t.reply,t),"error"in t&&this.#r.refused(t.reply,t)):("watch"in t?this.#r.hear(t):"arm"in t?(t.past??null)===this.moment&&this.onArm(t):this.#c.hear(t),"error"in t||this.#x())}#_(t){this.#n=_p,this.onHello(t),this.onState("live"),this.#h.begin(),this.#a.open(t.images);for(let e of[this.#r,this.#c])e.open()}#g(t){this.#l.stamp=t.pulse,this.#h.heard(),this.#u(zt("stamp"),t.pulse),this.onPulse(t)}#x(){this.#i++>0||setTimeout(()=>{this.#u(zt("heard"),this.#i),this.#i=0},$x)}get moment(){return this.#r.moment}showMoment=this.#r.showMoment.bind(this.#r);follow(t,e){this.#r.follow(t,e)}followAlways(t,e){this.#r.follow(t,e,!0)}watch=this.#r.watch.bind(this.#r);ask=this.#r.ask.bind(this.#r);askThen=this.#r.askThen.bind(this.#r);request(t,e){return this.#o.call("request",zt(t),typeof e=="string"?si(e):e)}goal(t,e){return this.#o.callWith(e,"goal",t)}stop(t){return this.#l.stop(t)}clearStops(){return this.#o.call("clear-stops")}hold(t,e){return this.#o.call(t,zt(e))}async cells(){let[t]=await this.#o.call("cells");return JSON.parse(t)}async method(t){let[e]=await this.#o.call("method",t);return JSON.parse(e)}jog=this.#l.jog.bind(this.#l);holdOn=this.#l.holdOn.bind(this.#l);release=this.#l.release.bind(this.#l);layTruth=this.#c.layTruth.bind(this.#c);sampleActivity=this.#c.sampleActivity.bind(this.#c);earlierWork=this.#c.earlierWork.bind(this.#c);look=this.#a.add.bind(this.#a);async picture(t,e){let[n]=await this.#o.call("picture",zt(t),e);return n}async#m(t){let[e,n]=await wu(t);this.#o.hear(e,n?{values:[n]}:{error:{sentence:"what was kept is no picture"}})}};function Sl(i){let t=bt("confirm");return bt("confirm-text").textContent=i,t.showModal(),new Promise(e=>{let n=new AbortController,s=r=>{n.abort(),e(r)};t.addEventListener("submit",r=>s(r.submitter?.getAttribute("value")==="yes"),{signal:n.signal}),t.addEventListener("close",()=>t.open||s(!1),{signal:n.signal})})}function ri(i,t){if(i===t)return"you";let e=/^(?:(.+)\/)?console-(\d+)-(\d+)$/,[,n,s,r]=i.match(e)??[];if(!r)return i;let o=s===t.match(e)?.[2]?"":` of console ${s}`;return`${n?`${n}, `:""}page ${r}${o}`}var Ml=class{#e;#t;#n=[];#i=[];#s=[];#r="";#o=!1;#a=!1;#l=!1;change=null;me="";robot="robot";constructor(t,e){this.#e=t,this.#t=e,t.followAlways("(commander ?robot ?client)",n=>{this.#i=n.map(ht),this.#c(),this.changed()}),t.followAlways("(commander-wanted ?robot ?client)",n=>{this.#s=n.map(ht),this.changed()}),e.onChange(()=>this.changed())}get holder(){let t=this.#i.find(e=>Y(e[1])===this.robot);return t?Y(t[2]):""}get mine(){return this.#t.live&&this.me!==""&&this.holder===this.me}get whyNotTaken(){return this.#t.line||this.#t.right("command")}get why(){return this.whyNotTaken||this.#t.command("request")||(this.mine?"":"Take the arm in hand first")}get holderName(){return ri(this.holder,this.me)}get askers(){return this.#s.filter(e=>Y(e[1])===this.robot).map(e=>Y(e[2])).filter(e=>e!==this.me).map(e=>ri(e,this.me))}get asking(){return this.#s.some(t=>Y(t[1])===this.robot&&Y(t[2])===this.me)}#c(){let t=this.#r,e=this.#o,n=this.holder;if(this.#r=n,this.#o=n!==""&&n===this.me,t===n)return;let s={from:ri(t,this.me),to:ri(n,this.me)};this.#o?this.change=t?s:null:e&&!this.#a&&(this.change=s),this.#a=!1}onChange(t){this.#n.push(t),t(this.mine,this.holder)}changed(){let t=bt("arm-chip");t.hidden=this.holder==="",t.textContent=this.mine?"arm: in your hands":`arm: ${this.#t.live?this.holderName:"not known"}`,t.className=this.mine?"chip good":"chip warn";for(let e of this.#n)e(this.mine,this.holder);this.#h()}async#h(){if(!this.#t.live||!this.asking||this.#l||!(this.mine||this.holder===""))return;this.#l=!0;let t=this.mine?"ask-no-more":"command";await this.#e.hold(t,this.robot).catch(()=>{}),this.#l=!1,this.mine&&this.#h()}async toggle(){return this.mine?this.#f():this.holder===""?this.#e.hold("command",this.robot):await Sl(`${this.holderName} has the arm in hand. Take it over? Its motion ends.`)?this.#e.hold("take-over",this.robot):void 0}async#f(){this.#a=!0;try{await this.#e.hold("let-go",this.robot)}catch(t){throw this.#a=!1,t}}toggleWish(){return this.#e.hold(this.asking?"ask-no-more":"ask-for",this.robot)}};function Li(i,t){let e=C("tbody",{}),n=s=>s instanceof HTMLTableCellElement?s:C("td",{},s instanceof Node?s:$t(String(s)));return{panel:C("table",i,C("thead",{},C("tr",{},...t.map(s=>C("th",{},s)))),e),fill:s=>e.replaceChildren(...s.map(r=>C("tr",{},...r.map(n))))}}var xp=10,bl=560,yp=220,Zo={width:104,height:26},vp=["QUERY","SEND","PUSH","EVENT","STREAM"],Sp=15,Yx=i=>i.length>Sp?`${i.slice(0,Sp-1)}\u2026`:i;function Zx({components:i,connections:t}){let e=new Map(i.map(({name:o},a)=>{let l=2*Math.PI*a/i.length-Math.PI/2;return[o,{x:bl/2+(yp+10)*Math.cos(l),y:bl/2+yp*Math.sin(l)}]})),n=({from:o,to:a,pattern:l,about:c})=>{let[f,u]=[e.get(o),e.get(a)];if(!f||!u)return null;let h=Math.max(Math.hypot(u.x-f.x,u.y-f.y),1),[d,p]=[(u.x-f.x)/h,(u.y-f.y)/h],_=4+5*vp.indexOf(l),g=Math.min(Zo.width/2/Math.max(Math.abs(d),.01),Zo.height/2/Math.max(Math.abs(p),.01))+4,m={x1:f.x+d*g+p*_,y1:f.y+p*g-d*_,x2:u.x-d*g+p*_,y2:u.y-p*g-d*_},v=Sn("title",{},`${o} ${l} ${a}: ${c.join(" ")}`);return Sn("line",{...m,class:`way ${l}`,"marker-end":`url(#end-${l})`},v)},s=vp.map(o=>Sn("marker",{id:`end-${o}`,markerWidth:7,markerHeight:7,refX:6,refY:3,orient:"auto"},Sn("path",{d:"M0,0 L6,3 L0,6 z",class:o}))),r=[...e].flatMap(([o,{x:a,y:l}])=>[Sn("rect",{x:a-Zo.width/2,y:l-Zo.height/2,...Zo,rx:5,class:"component"}),Sn("text",{x:a,y:l+4,"text-anchor":"middle"},Yx(o))]);return Sn("svg",{class:"graph",viewBox:`0 0 ${bl} ${bl}`,role:"img","aria-label":`${i.length} components and ${t.length} connections`},Sn("defs",{},...s),...t.map(n).filter(Boolean),...r)}var Jx=[["physical","a device"],["performance","a reaction time"],["abstraction","a function"]];function Kx({components:i,wrappers:t}){let e=new Map(t.map(n=>[n.component,n]));return i.map(n=>{let s=e.get(n.name),r=Jx.filter(([a])=>n[a]).map(([,a])=>a),o=(s?.abstraction??[]).map(a=>`${a.wrapped} ${a.operations}/${a.functions} = ${a.i_abstract.toFixed(3)}`);return[n.name,r.join(", ")||"none told",s?.offered??0,o.join("; ")||"\u2013",(s?.parts??[]).join(" ")]})}function jx({connections:i}){return i.map(t=>[`${t.from} \u2192 ${t.to}`,t.pattern,t.count,t.p50_ms?`${t.p50_ms.toFixed(1)} / ${t.p99_ms.toFixed(1)}`:"\u2013",t.about.join(" "),t.remark||(t.recommended===t.pattern?"as the tables have it":t.recommended)])}function wl(i,...t){return C("section",{"aria-label":i},C("h2",{},i),...t)}function Tu(i,t,e){let n=Li({id:i},t);return n.fill(e),C("div",{class:"scroll",tabindex:0,role:"group","aria-label":t[0]},n.panel)}function Qx(i){let{i_cpx:t,i_struct:e,i_cnx:n}=i,s=i.scales.map(({subscribers:r,p50_ms:o})=>`${r}: ${o.toFixed(2)} ms`).join(", ");return[wl("Divide",C("p",{id:"indices"},`I_cpx ${t.toFixed(3)}, I_struct ${e.toFixed(3)}, I_cnx ${n.toFixed(3)}`),Zx(i),C("p",{class:"quiet"},"QUERY blue, SEND violet, PUSH green, EVENT orange, STREAM grey.")),wl("Wrap",Tu("wrappers",["Component","Is one for","Operations","I_abstract","Parts of a wrapper"],Kx(i))),wl("Connect",Tu("connections",["Connection","Pattern","Times","ms p50 / p99","About","The tables say"],jx(i))),wl("What is wrong",i.faults.length?Tu("faults",["Fault","Of","Why"],i.faults.map(r=>[r.symbol,r.subject,r.sentence])):C("p",{},"no fault was found"),s&&C("p",{class:"quiet"},`A fact reaches so many readers: ${s}.`))]}function Mp(i){let t=C("span",{class:"quiet",role:"status",id:"method-note"}),e=C("div",{id:"method"}),n=C("button",{type:"button",id:"method-look"},`Look for ${xp} s`);return n.addEventListener("click",async()=>{n.disabled=!0,t.textContent="looking at who asks, answers, tells and watches \u2026";try{let s=await i.method(xp);e.replaceChildren(...Qx(s).filter(Boolean)),t.textContent=`seen for ${s.seconds} s`}catch(s){t.textContent=Te(s)}n.disabled=!1}),C("details",{class:"goals"},C("summary",{},"The method: Divide, Wrap, Connect"),C("div",{class:"row"},n,t),e)}function bp(i,t){let e=Li({id:"processes"},["Process","Host","Restarts","The last of it"]),n=C("span",{class:"quiet"},"0"),s=new Map;return i.follow("(process ?host ?name ?running ?restarts ?newest)",o=>{let a=o.map(ht).sort((l,c)=>Y(l[2]).localeCompare(Y(c[2])));s.clear();for(let[,,l,,c]of a)s.set(Y(l),c);n.textContent=String(a.length),e.fill(a.map(([,l,c,f,u,h])=>[Y(c),Y(l),u,Y(f)==="yes"?Y(h):C("span",{class:"chip bad"},Y(h))])),t()}),{panel:C("details",{class:"goals"},C("summary",{},"Processes and their restarts ",n),e.panel),restarts:s}}var wp=50;function Tp(i,t){let e=C("span",{class:"quiet",id:"refusal-count"},"0"),n=Li({id:"refusals"},["Client","Refused","Times","The newest"]),s=Li({id:"clients"},["Client","Requests/s"]);i.follow("(board-refusal ?client ?symbol ?count ?sentence)",o=>{let a=o.map(ht).sort((l,c)=>c[3]-l[3]);e.textContent=String(a.length),n.fill(a.slice(0,wp).map(([,l,c,f,u])=>[Y(l),Y(c),f,Y(u)]))});let r=C("details",{class:"goals"},C("summary",{},"Refused by the board ",e),n.panel,s.panel);return t.shownIn(r,o=>s.fill((o?.clients??[]).slice(0,wp).map(a=>[a.name||"(no hello)",a.requests_per_second]))),r}var ty={wired:"","stands-in":"stands in",absent:"is away"},ey=64;function Ep(i){let t=C("tbody",{}),e=["Client","Role","Is played by",""].map(s=>C("th",{},s));i.follow("(holder ?client ?role ?server ?state)",s=>{let r=s.map(o=>ht(o).slice(1).map(Y)).sort();t.replaceChildren(...r.slice(0,ey).map(([o,a,l,c])=>C("tr",{class:c==="wired"?"":"warn"},...[o,a,l,ty[c]??c].map(f=>C("td",{},$t(f,64))))))});let n=C("table",{id:"served"},C("thead",{},C("tr",{},...e)),t);return C("details",{class:"goals",open:!0},C("summary",{},"Who serves whom"),n)}function ny(i,t){let e=i?`${i.told_per_second.toFixed(1)} told/s, ${i.waiting} waiting, ${i.queued} queued`:"",n=t===void 0?"":`${t} restart${t===1?"":"s"}`;return[e,n].filter(Boolean).join(", ")}function Ap(i,t){let e=C("div",{class:"timeline"}),n=new Map,s=new Map,r=[],o=new Map,a=f=>{if(s.has(f))return s.get(f);let u=C("span",{class:"quiet"}),h=C("span",{class:"quiet load"}),d=C("pre",{}),p=C("details",{"data-agent":f},C("summary",{},C("strong",{},$t(f,64)),u,h),d);return s.set(f,{made:p,who:u,does:h,offers:d}),s.get(f)},l=()=>{let f=r.slice(0,64).map(u=>{let h=Y(u[1]),{who:d,does:p,offers:_}=a(h);d.textContent=`${Y(u[2])} on ${$t(Y(u[3]),64)}`,p.textContent=ny(o.get(h),c.restarts.get(h));let g=n.get(h);return _.textContent=g?$t(g.map(te).join(`
`),6e3):"it told no contract",h});for(let u of s.keys())f.includes(u)||s.delete(u);e.replaceChildren(...f.map(u=>s.get(u).made))},c=bp(i,()=>l());bt("agents").append(e,c.panel,Tp(i,t),Ep(i),Mp(i)),t.shownIn(e,f=>{o=new Map((f?.agents??[]).map(u=>[u.name,u])),l()}),i.follow("(agent ?name ?kind ?host)",f=>{r=f.map(ht).sort((u,h)=>Y(u[1]).localeCompare(Y(h[1]))),l()}),i.follow("(contract ?name ?form)",f=>{n.clear();for(let[,u,h]of f.map(ht))n.set(Y(u),h.filter(Array.isArray));l()})}var iy=5e3,Rp=["Cell","Agents","Goal","Arms","Stopped by","Last word"],Cp=i=>i&&C("span",{class:"chip bad"},i);function sy({path:i,console:t,leads:e}){let n=i||"this one",s=t.startsWith("https://");return C("td",{},s?C("a",{href:t,target:"_blank",rel:"noopener noreferrer"},n):n,e&&C("small",{class:"quiet"},`${e} leads`))}function ry(i){let t=sy(i);return i.fault?[t,C("td",{colspan:Rp.length-1},Cp(i.fault))]:[t,i.agents,i.goal,i.arms,Cp(i.stops),i.said]}function oy(i,t){let e=document.activeElement,n=e instanceof HTMLAnchorElement&&i.panel.contains(e)&&e.href;i.fill(t),n&&[...i.panel.querySelectorAll("a")].find(s=>s.href===n)?.focus()}function Pp(i){let t=Li({id:"cells-table"},Rp),e=C("p",{class:"quiet",role:"status"},"looking \u2026"),n=bt("cells");n.append(t.panel,e);let s=!1,r=!1,o=0,a=async()=>{if(clearTimeout(o),!(r||!s)){r=!0;try{let l=await i.cells();oy(t,l.cells.map(ry)),e.textContent=l.more?`More than these ${l.cells.length} are named: ./pizarra cells lists all`:""}catch(l){e.textContent=Te(l)}r=!1,o=setTimeout(a,iy)}};new IntersectionObserver(l=>{s=l[l.length-1].isIntersecting,a()}).observe(n),i.follow("(context-board ?name ?address)",l=>{l.length>0&&(bt("tab-cells").hidden=!1)})}var ay=/^(Arrow\w+|Page\w+|Home|End)$/;function Ip(i,t,e){let n=C("output",{},""),s=C("input",{type:"range","aria-label":i,...e}),r=()=>{n.textContent=`${s.value} ${t}`,s.setAttribute("aria-valuetext",n.textContent)};return s.addEventListener("input",r),r(),{row:C("label",{class:"slide"},C("span",{},i),s,n),input:s,show:r}}function Lp(i,{letGo:t,drop:e}){let n="";i.addEventListener("pointerdown",()=>n="pointer"),i.addEventListener("keydown",r=>{ay.test(r.key)&&(n="key")});let s=()=>{n="",t()};i.addEventListener("change",()=>n!=="key"&&s()),i.addEventListener("keyup",()=>n==="key"&&s()),i.addEventListener("pointerup",()=>n="");for(let r of["pointercancel","blur"])i.addEventListener(r,()=>{n="",e()});return()=>n!==""}function Tl({label:i,unit:t,most:e,form:n},s){let{row:r,input:o,show:a}=Ip(i,t,{min:-e,max:e,step:1,value:0}),l=()=>{let f=Number(o.value);return o.value="0",a(),f};return Lp(o,{letGo:()=>{let f=l();f!==0&&s(n(f))},drop:l}),o.addEventListener("keydown",f=>f.key==="Escape"&&l()),{row:r,input:o}}function Jo({label:i,unit:t,least:e,most:n,value:s,form:r},o){let{row:a,input:l,show:c}=Ip(i,t,{min:e,max:n,step:1,value:s}),f=s,u=()=>{l.value=String(f),c()},h=Lp(l,{letGo:()=>o(r(Number(l.value))),drop:u});return{row:a,input:l,put:p=>{f=p,h()||u()}}}var Ko=(i,t,e)=>n=>`(${i} ${n>0?t:e} ${Math.abs(n)})`,ly=[{label:"Retract / extend",unit:"mm",most:100,form:i=>i>0?`(extend keep-height ${i})`:`(retract ${-i})`},{label:"Turn left / right",unit:"\xB0",most:45,form:Ko("turn","right","left")},{label:"Move left / right",unit:"mm",most:100,form:Ko("move-h","right","left")},{label:"Move down / up",unit:"mm",most:100,form:Ko("move-v","up","down")},{label:"Tool down / up",unit:"\xB0",most:45,form:Ko("turn-ef","up","down")},{label:"Wrist left / right",unit:"\xB0",most:90,form:Ko("turn-wrist","right","left")}],cy=i=>({label:"Gripper close / open",unit:"mm",most:60,form:t=>`(gripper ${Math.max(0,Math.round(i()+t))})`}),Dp={label:"Gripper opening",unit:"mm",least:0,most:100,value:80,form:i=>`(gripper ${i})`},hy={label:"Speed",unit:"%",least:1,most:100,value:50,form:i=>`(speed ${i})`};function Np(i,t,e){let n=Dp.value,s=[...ly,cy(()=>n)].map(l=>Tl(l,e)),r=Jo(Dp,e),o=Jo(hy,e),a=(l,c)=>i.follow(l,f=>{let u=f.map(ht).find(h=>Y(h[1])===t.robot);u&&c(u[2])});return a("(robot-speed ?robot ?percent)",o.put),a("(gripper ?robot ?opening)",l=>{n=l,r.put(Math.round(l))}),{rows:[...s,r,o].map(l=>l.row),moving:[...s,r].map(l=>l.input),speed:o.input}}var uy=60,Vr=class{#e;#t;#n;list;constructor(t,e,n,s){this.#e=t,this.#t=e,this.#n=n,this.list=C("ol",{class:"log","aria-label":s}),t.followAlways("(request ?id ?agent ?operation)",(r,o)=>this.#s(o.added))}#i(t,e){let n=C("span",{}),s=C("li",{},C("time",{},We(Date.now()*1e3)),C("span",{class:"quiet"},`${$t(t,40)} `),C("code",{},$t(e,200)),n);for(this.list.prepend(s);this.list.children.length>uy;)this.list.lastChild?.remove();return{item:s,answer:n}}#s(t){for(let e of t){let{teller:n}=e.facts[0],[,,s,r]=ht(e);Y(s)===this.#t()&&n!==this.#n()&&this.#i(ri(n,this.#n()),te(r))}}async follow(t,e){let{item:n,answer:s}=this.#i("you",t);s.textContent=" \u2026";try{s.textContent=` ${$t((await e).join(" ")||"ok",200)}`}catch(r){s.textContent=` ${Te(r)}`,n.className="bad"}}send(t){return this.follow(t,this.#e.request(this.#t(),si(t)))}};var fy=50,dy=[["left","\u25C0","Left"],["up","\u25B2","Up"],["out","\u21E7","Out"],["turn-left","\u27F2","Turn left"],["tool-up","\u2912","Tool up"],["wrist-left","\u21BA","Wrist left"],["right","\u25B6","Right"],["down","\u25BC","Down"],["in","\u21E9","In"],["turn-right","\u27F3","Turn right"],["tool-down","\u2913","Tool down"],["wrist-right","\u21BB","Wrist right"]],Eu=class{#e;#t;#n;#i;#s=null;#r=null;constructor(t,e,n){this.#e=t,this.#t=e,this.#n=n,e.onChange(()=>e.why&&this.end()),window.addEventListener("blur",()=>this.end()),window.addEventListener("pagehide",()=>this.end()),document.addEventListener("visibilitychange",()=>{document.hidden&&this.end()})}begin(t,e){if(this.#s||this.#t.why)return;let n={button:e};this.#s=n,e.classList.add("held");let s=()=>this.#s===n&&this.#o(t,n);this.#r?this.#r.then(s):s()}#o(t,e){let n=this.#e.jog(this.#t.robot,t);this.#n.follow(`(jog ${t})`,n),this.#i=setInterval(()=>this.#e.holdOn(),fy);let s=()=>{this.#r=null,this.#s===e&&this.end()};this.#r=n.then(s,s)}end(){this.#s&&(clearInterval(this.#i),this.#e.release(),this.#s.button.classList.remove("held"),this.#s=null)}};function py(i,[t,e,n]){let s=C("button",{type:"button",class:"jog","data-jog":t,"aria-label":`Jog: ${n}`,title:n},C("span",{"aria-hidden":"true"},e),C("small",{"aria-hidden":"true"},n));s.addEventListener("pointerdown",r=>{r.button===0&&(s.setPointerCapture(r.pointerId),i.begin(t,s))});for(let r of["pointerup","pointercancel","lostpointercapture","blur"])s.addEventListener(r,()=>i.end());return s.addEventListener("contextmenu",r=>r.preventDefault()),s.addEventListener("keydown",r=>{r.key==="Escape"&&i.end(),!(r.key!==" "&&r.key!=="Enter")&&(r.preventDefault(),r.repeat||i.begin(t,s))}),s.addEventListener("keyup",r=>{(r.key===" "||r.key==="Enter")&&i.end()}),s}function Up(i,t,e){let n=new Eu(i,t,e),s=dy.map(a=>py(n,a)),r=C("p",{class:"quiet",id:"jog-note"},"");return i.onPulse=({deadline:a,rtt:l})=>{let c=l<0?"not measured yet":`${l.toFixed(0)} ms there and back`;r.textContent=`Hold to move. Line: ${c}; silence of ${a.toFixed(0)} ms stops the arm, within 10 mm.`},{parts:[C("div",{class:"jogs",role:"group","aria-label":"Jog: hold to move"},...s),r],buttons:s}}function Fp(i,t,e){let n=C("datalist",{id:"variables"}),s=C("input",{id:"variable",list:"variables",maxlength:32,size:12,spellcheck:"false",placeholder:"p1","aria-label":"Name of a place",pattern:"[a-z][a-z0-9\\-]*",title:"a letter, then letters, digits and hyphens"}),r=l=>()=>s.value&&s.reportValidity()&&e.send(`(${l} ${s.value})`),o=C("button",{type:"button",onclick:r("learn")},"Save"),a=C("button",{type:"button",onclick:r("goto")},"Go to");return i.follow("(robot-variable ?robot ?name ?joints)",l=>{let c=l.map(ht).filter(f=>Y(f[1])===t.robot);n.replaceChildren(...c.map(f=>C("option",{value:Y(f[2])})))}),{parts:[s,n,o,a],name:s,save:o,go:a}}var Mn=class{note;#e=new Map;constructor(t){this.note=C("p",{class:"reasons",id:t,hidden:!0})}set(t,e,n){for(let r of e)r.dataset.title??=r.title,r.disabled=n!=="",r.title=n||r.dataset.title,n?r.setAttribute("aria-describedby",this.note.id):r.removeAttribute("aria-describedby");let s=e.length>0?n:"";(this.#e.get(t)??"")!==s&&(this.#e.set(t,s),this.#t())}#t(){let t=new Map;for(let[e,n]of this.#e)n&&t.set(n,[...t.get(n)??[],e]);this.note.replaceChildren(...[...t].map(([e,n])=>C("span",{},C("strong",{},n.join(", ")),`: ${e}. `))),this.note.hidden=t.size===0}};function Op(i,t,e){let n=C("span",{id:"service-light",class:"chip",role:"status"}),s=new Set,r=new Map,o=()=>s.has(t.robot)?r.has(t.robot)?`${ri(r.get(t.robot)??"",t.me)} released control: get it first`:"":"No robot is present",a=()=>{n.textContent=o()||"In service",n.className=`chip ${o()?"bad":"good"}`,e()};return i.followAlways("(agent ?name robot ?host)",l=>{s=new Set(l.map(c=>Y(ht(c)[1]))),a()}),i.followAlways("(robot-released ?robot ?client)",l=>{r=new Map(l.map(c=>[Y(ht(c)[1]),Y(ht(c)[2])])),a()}),t.onChange(a),{light:n,why:o}}function Bp(i,t){let e=new Mn("why-take"),n=C("span",{class:"quiet"}),s=a=>()=>a().catch(l=>n.textContent=Te(l)),r=C("button",{type:"button",id:"take-arm",class:"strong",onclick:s(()=>i.toggle())}),o=C("button",{type:"button",id:"ask-for-arm",onclick:s(()=>i.toggleWish())});return i.onChange((a,l)=>{e.set("The arm in hand",[r],i.whyNotTaken);let c=l!==""&&!a;e.set("To ask for it",c?[o]:[],t.line||t.right("ask-for")),o.hidden=!c,o.textContent=i.asking?"Ask no more":"Ask for it",r.textContent=a?"Let the arm go":l?`Take over from ${i.holderName}`:"Take the arm in hand";let f=i.asking?`${i.holderName} is asked for it.`:"";n.textContent=a?"Only you move the arm now.":l?f:"Anybody may move the arm: a goal, a prompt."}),[C("div",{class:"row"},r,o,n),e.note]}function my(i,t,e){let n=C("output",{class:"axes","aria-label":"Axis positions"},"no arm has told its joints yet");return i.follow("(arm-joints ?robot ?joints)",s=>{let r=s.map(ht).find(o=>Y(o[1])===t.robot);r&&(n.textContent=e.words(t.robot,r[2]).map(o=>o.join(" ").replaceAll(" ","\xA0")).join("   "))}),n}function gy(i){let t=C("input",{id:"action",maxlength:4e3,spellcheck:"false",placeholder:"(move 350 0 300)   or   CIRCLE p1, p2, p3","aria-label":"Action"}),e=C("button",{type:"submit"},"Do action"),n=C("form",{class:"row"},t,e);return n.addEventListener("submit",s=>{s.preventDefault(),t.value&&i.send(te([zt("do-action"),t.value]))}),{form:n,controls:[t,e]}}function _y(i,t,e){let n=p=>e.send(p),s=(p,_)=>C("button",{type:"button",onclick:()=>n(_)},p),r=[s("Home","(home)"),s("Ready","(ready)")],o=[s("Get control","(get-control)"),s("Release control","(release-control)")],a=[s("Monitor","(monitor)"),s("Finish: report","(finish report)"),s("Finish: stop","(finish stop)"),s("Status","(get-status)")],l=Up(i,t,e),c=Np(i,t,n),f=Fp(i,t,e),u=gy(e),h=[...r,...c.moving,f.go,...u.controls],d=[...o,c.speed,f.name,f.save];return{poses:r,service:o,questions:a,jog:l,slides:c,places:f,action:u,moving:h,still:d}}function kp({connection:i,permission:t,hands:e,axes:n}){let s=new Vr(i,()=>e.robot,()=>e.me,"Commands that the arm received, newest first"),{poses:r,service:o,questions:a,jog:l,slides:c,places:f,action:u,moving:h,still:d}=_y(i,e,s),p=new Mn("why-drive"),_=()=>{},{light:g,why:m}=Op(i,e,()=>_());_=()=>{p.set("Jogs",l.buttons,t.right("jog")||e.why||m()),p.set("Slides, poses and actions",h,e.why||m()),p.set("Speed, places and control",d,e.why),p.set("Questions and Finish",a,t.line||t.right("request"))},bt("drive").append(...Bp(e,t),p.note,C("div",{class:"row"},g,...o,...r),C("div",{class:"row"},...a),C("div",{class:"driving"},C("div",{},...l.parts),C("div",{class:"slides"},...c.rows)),C("div",{class:"row"},...f.parts,my(i,e,n)),u.form,C("h2",{},"Commands received"),s.list),_()}var El=class{#e;#t=new Map;#n=[];constructor(t){this.#e=t,t.followAlways("(holder console ?role ?server ?state)",e=>{let n=e.map(ht).filter(([,,,,s])=>Y(s)!=="absent");this.#t=new Map(n.map(([,,s,r])=>[Y(s),Y(r)]));for(let s of this.#n)s()})}server(t){return this.#t.get(t)??""}follow(t,e,n){let s=[],r=()=>{let o=this.server(t);n(o===""?s:s.filter(a=>Y(a[1])===o))};this.#e.follow(e,o=>{s=o.map(ht),r()}),this.onChange(r)}onChange(t){this.#n.push(t)}};var xy={looking:"looking for boards",fitting:"fitting",done:"done",failed:"failed"},yy={done:"good",failed:"bad"},Gr=3,vy=64,Sy=32,My=8192,Al={missing:"#4b3a17",grid:"#2a3b47",taken:"#7fd18b",now:"#f2a33a"};function zp(i,t,e,n){let s=ji(i);s.strokeStyle=e,s.lineWidth=n,s.beginPath();for(let r=0;r+1<t.length;r+=2)s.lineTo(t[r],t[r+1]);s.closePath(),s.stroke()}function by(i,t){let e=ji(i),[n,s]=[i.width/Gr,i.height/Gr];e.clearRect(0,0,i.width,i.height),e.fillStyle=Al.missing;for(let[,r,o]of t)e.fillRect(r*n,o*s,n,s);e.strokeStyle=Al.grid,e.lineWidth=1;for(let r=0;r<Gr*Gr;++r)e.strokeRect(r%Gr*n,Math.floor(r/Gr)*s,n,s)}function Vp(){let i=C("canvas",{role:"img"}),t=C("small",{});return{canvas:i,label:t,box:C("div",{class:"boards"},i,t)}}function Gp(i){let t=C("span",{class:"chip",id:"calibration-state",role:"status"}),e=C("span",{id:"calibration-count"}),n=C("p",{id:"calibration-sentence",hidden:!0}),s=C("span",{class:"quiet",id:"calibration-sees"}),r=C("ul",{id:"calibration-lacks","aria-label":"Still missing"}),o=[Vp(),Vp()],a=C("section",{id:"calibration","aria-label":"Calibration",hidden:!0},C("div",{class:"row"},C("h2",{},"Calibration"),t,e,s),n,C("div",{class:"calibrating"},...o.map(d=>d.box),r)),l,c=[],f=[],u=[],h=()=>{if(a.hidden=l===void 0,l===void 0)return;let[,d,p,_,g,m,v]=l,A=Y(d);t.textContent=xy[A]??A,t.className=`chip ${yy[A]??"busy"}`,e.textContent=`${m} of ${v} boards`,n.textContent=$t(Y(p),1e3),n.hidden=n.textContent==="";let S=u.map(([,E])=>$t(Y(E)));r.replaceChildren(...(S.length?S:["nothing more"]).map(E=>C("li",{},E)));let R=c.some(E=>1 in E);o.forEach(({canvas:E,label:x,box:T},U)=>{let N=[_,g].every(L=>L>0&&L<=My);if(T.hidden=!N||!c.some(L=>U in L),!T.hidden){x.textContent=`Boards in the ${R?["left ","right "][U]:""}image`,E.setAttribute("aria-label",x.textContent),Object.assign(E,{width:_,height:g}),by(E,u.map(([,,L])=>L).filter(([L])=>L===U));for(let L of c)U in L&&zp(E,L[U],Al.taken,2);U in f&&zp(E,f[U],Al.now,4)}})};return i.follow("(calibration ?state ?sentence ?width ?height ?boards ?wanted)",d=>{l=d.length?ht(d[0]):void 0,h()}),i.follow("(calibration-board ?number ?outlines)",d=>{c=d.slice(0,vy).map(p=>ht(p)[2]),h()}),i.follow("(calibration-sees ?outlines ?sentence)",d=>{f=d.length?ht(d[0])[1]:[],s.textContent=d.length?`the newest image: ${$t(Y(ht(d[0])[2]))}`:"",h()}),i.follow("(calibration-lacks ?sentence ?part)",d=>{u=d.slice(0,Sy).map(ht),h()}),a}var lr="end-effector",Hp="unnamed-",Wp=i=>Hp+i,Rl=i=>!i.startsWith(Hp),wy=["Area","Perimeter","NF","M0","M1","M2"],Cl=class{#e=[];#t=new Map;#n=[];#i=[];constructor(t){let e=(n,s)=>t.follow("eyes",n,r=>{s(r),this.#s()});e("(learned ?eyes ?name ?num ?area ?perimeter ?nf ?m0 ?m1 ?m2)",n=>this.#e=n),e("(learned-template ?eyes ?name ?num ?tone ? ? ? ? ? ? ?picture)",n=>{this.#t=new Map(n.map(s=>[`${s[1]} ${s[2]} ${s[3]}`,s]))}),e("(look-alike ?eyes ?name ?other ?error ?sentence)",n=>this.#n=n)}onChange(t){this.#i.push(t)}#s(){for(let t of this.#i)t()}names(){let t=[...new Set(this.#e.map(e=>Y(e[2])))].sort();return t.includes(lr)?[lr,...t.filter(e=>e!==lr)]:t}samples(t){return this.#e.filter(e=>Y(e[2])===t).map(e=>this.#r(e))}newest(t){return this.samples(t).toSorted((e,n)=>n.num-e.num)[0]}alike(t){return this.#n.filter(e=>[Y(e[2]),Y(e[3])].includes(t)).map(e=>Y(e[5]))}#r(t){let e=this.#t.get(`${t[1]} ${t[2]} ${t[3]}`),n=t.slice(4).map((s,r)=>[wy[r],s.toFixed(Number.isInteger(s)?0:3)]);return{eyes:Y(t[1]),num:t[3],parameters:n,picture:e?Y(e.at(-1)):"",tone:e?Y(e[4]):"dark"}}};var Hr=32;function Pl(i,t,e){let n=C("canvas",{class:"template",width:Hr,height:Hr,role:"img","aria-label":e});if(!/^[0-9a-f]{1024}$/.test(i))return n;let s=ji(n),r=s.createImageData(Hr,Hr);for(let o=0;o<Hr*Hr;++o){let a=parseInt(i[o],16)/15,l=Math.round(255*(t==="light"?a:1-a));r.data.set([l,l,l,255],4*o)}return s.putImageData(r,0,0),n}var Ty=[lr,"circle","triangle","square","cross"],Ey=i=>/^\(LEARN ".*" OK\)$/.test(i[0]??""),Il=class{#e;#t;#n;#i;#s=!1;#r=null;panel=C("div",{class:"teaching"});training=C("button",{type:"button",id:"training","aria-pressed":"false"},"Training: off");#o=C("p",{class:"quiet",id:"teach-hint",role:"status"});#a=C("input",{id:"learn-name",list:"learned-names",maxlength:64,spellcheck:"false",placeholder:"a name, or none yet",pattern:"[A-Za-z][A-Za-z0-9\\-]*",title:"a letter, then letters, digits and hyphens"});#l=C("datalist",{id:"learned-names"});#c=C("div",{class:"learned-sample"});#h=C("div",{class:"learned-window",id:"learned-window",role:"group",hidden:!0});constructor({ask:t,objects:e,provisional:n,why:s}){this.#e=t,this.#t=e,this.#n=n,this.#i=s,this.training.addEventListener("click",()=>this.#d(!this.#f)),this.panel.append(C("div",{class:"row"},this.training,C("label",{for:"learn-name"},"Name"),this.#a),this.#l,this.#o,this.#h),e.onChange(()=>{this.#p(),this.#s||this.#m()}),this.#p()}get#f(){return this.training.getAttribute("aria-pressed")==="true"}#d(t){this.training.setAttribute("aria-pressed",String(t)),this.training.textContent=`Training: ${t?"on":"off"}`,document.body.classList.toggle("training",t),this.#p()}#u(t){this.#o.textContent=t}#p(){let t=this.#t.names().filter(n=>n!==this.#n());if(this.#l.replaceChildren(...t.map(n=>C("option",{value:n}))),this.#s)return;let e=t.includes(lr)?"":" Begin with the end-effector: the triangle on the gripper.";this.#u(this.#f?`Click on a mark in the camera\u2019s image.${e}`:"Switch training on, and click on a mark."),this.#f&&e&&this.#a.value===""&&(this.#a.value=lr)}more(t){this.#d(!0),this.#a.value=t}take(t){return this.#f?(this.#s||!this.#a.reportValidity()||this.#g(t,this.#a.value||this.#n()),!0):!1}#_(t){return this.#t.newest(t)?.num??0}async#g(t,e){this.#s=!0,this.#h.hidden=!0,this.#u(`Learning what is at ${t.x}, ${t.y} of frame ${t.frame}: red while it is filled, then its border.`);let n=this.#_(e);try{let s=await this.#e(zt("learn"),t.x,t.y,t.frame,e);if(!Ey(s))throw{said:`${s[0]??"FAIL"}: ${await this.#i(s[0]??"")}`};this.#r={name:e,before:n},this.#x(e)}catch(s){this.#u(`${Te(s)}. For one more sample of an object write its name first; then click again.`)}this.#s=!1}#x(t){let e=t===this.#n(),n=C("input",{id:"new-name",required:!0,maxlength:64,spellcheck:"false",pattern:"[A-Za-z][A-Za-z0-9\\-]*",title:"a letter, then letters, digits and hyphens",value:e?"":t}),s=this.#t.names(),r=l=>C("button",{type:"button",class:"small",onclick:()=>n.value=l},l),o=e?Ty.filter(l=>!s.includes(l)).map(r):[],a=C("form",{class:"row"},C("label",{for:"new-name"},"Name it"),n,...o,C("button",{type:"submit",class:"strong"},"Accept"),C("button",{type:"button",id:"reject",onclick:()=>this.#S()},"Reject"));a.addEventListener("submit",l=>{l.preventDefault(),this.#v(n.value)}),this.#h.replaceChildren(this.#c,a),this.#m(),this.#h.hidden=!1,this.#u("Learned. Accept it under a name, or reject it."),n.focus()}#m(){let{name:t,before:e}=this.#r??{name:"",before:0},n=this.#t.newest(t);if(!n||n.num<=e)return this.#c.replaceChildren();let r=[["Name",t===this.#n()?"to be named":t],...n.parameters,["Num",String(n.num)]];this.#c.replaceChildren(Pl(n.picture,n.tone,`What was learned as ${t}`),C("dl",{class:"parameters"},...r.flatMap(([o,a])=>[C("dt",{},o),C("dd",{},a)])),...this.#t.alike(t).map(o=>C("p",{class:"warn"},$t(o))))}async#y(t,e,n){let s=this.#r;if(this.#s||!s)return;this.#s=!0,this.#u(t);let r=n;try{await e(s.name),this.#r=null,this.#h.hidden=!0,this.#a.value=""}catch(o){r=Te(o)}this.#s=!1,this.#p(),this.#u(r)}#v(t){let e=async n=>{t!==n&&await this.#e(zt("rename"),n,t),this.#r={name:t,before:0},await this.#e(zt("accept"),t)};return this.#y(`Accepting ${t} \u2026`,e,`${t} is accepted. Click on the next mark.`)}#S(){return this.#y("Rejecting \u2026",t=>this.#e(zt("reject"),t),"Rejected: nothing was learned.")}};function Ay(i,t,e){if(i)return{connect:i,disconnect:i,find:i,train:i,forget:i,track:i,end:i};let n=f=>t.filter(([,u])=>u===f).map(([u])=>u),s=f=>ri(f,e),r=n("tracking"),o=n("learning"),a=r.length?`${r.map(s).join(", ")} ${r.includes(e)?"track":"tracks"}, which excludes learning: end that first`:"",l=o.length?`${s(o[0])} ${o[0]===e?"are":"is"} learning`:"",c=n("connected").includes(e);return{connect:c?"you are connected":"",disconnect:c?"":"you are not connected",find:"",train:a||(o.includes(e)?"":l),forget:a||l,track:l,end:r.includes(e)?"":r.length?`${s(r[0])} tracks, and ends it itself`:"nothing is tracked"}}var Cy=([,,,i,,t])=>Y(i)==="lost"?"lost":`${Y(i)}, ${(t*100).toFixed(0)} %`;function Xp({connection:i,permission:t,images:e,roles:n},s){let r=bt("eyes"),o=C("pre",{class:"answer",id:"eyes-answer",role:"status",hidden:!0}),a=C("span",{id:"eyes-mode",class:"chip"},"no eyes"),l=C("span",{class:"quiet"}),c=C("pre",{class:"answer","aria-label":"What TRACK says",hidden:!0}),f=new Cl(n),u="vision",h=!1,d=[],p=(...O)=>i.request(u,O),_=async O=>{let P=await i.ask([zt("vision-failed"),zt(u),zt("?"),O,zt("?"),zt("?sentence")]);return P.length?Y(ht(P[0])[5]):"no reason was told"},g=async(...O)=>{o.hidden=!1,o.textContent="\u2026";try{let P=await p(...O),G=/ FAIL\)/.test(P[0]??"")?`
${await _(P[0])}`:"";o.textContent=$t((P.join(`
`)||"ok")+G,2e3)}catch(P){o.textContent=Te(P)}},m=(O,...P)=>C("button",{type:"button",onclick:()=>g(...P)},O),v=m("Connect",zt("connect")),A=m("Disconnect",zt("disconnect")),S=m("End track",zt("end-track")),R=new Il({ask:p,objects:f,provisional:()=>Wp(s().replace(/\D+/g,"-").replace(/^-/,"")),why:_});e.onPoint(O=>R.take(O));let E=new Mn("why-eyes"),x=C("ul",{class:"objects","aria-label":"Learned objects"});r.append(Gp(i),C("div",{class:"row"},a,l),C("div",{class:"row"},v,A,S),E.note,R.panel,o,c,x);let T=new Map,U=new Map,N=()=>{for(let[O,{state:P}]of U){let G=T.get(O);P.textContent=G?Cy(G):"not tracked"}},L=O=>{let P=f.samples(O),G=JSON.stringify([P,f.alike(O)]);if(U.get(O)?.of===G)return U.get(O);let q=C("span",{}),H=m("Find",zt("find"),O),ct=m("Track",zt("track"),O),K=m("Forget",zt("forget"),O),et=C("button",{type:"button",onclick:()=>R.more(O)},"Add sample"),st=[...new Set(P.map(Q=>Q.eyes))].join(", "),pt=f.alike(O).map(Q=>C("small",{class:"warn"},$t(Q,160))),dt=C("li",{},C("span",{class:"templates"},...P.map(Q=>Pl(Q.picture,Q.tone,`Sample ${Q.num} of ${$t(O,64)}`))),C("span",{},C("strong",{},Rl(O)?$t(O,64):"not named yet"),C("span",{class:"quiet"},` ${P.length} sample${P.length>1?"s":""} by ${$t(st,64)}; `,q),...pt),C("span",{class:"buttons"},H,ct,et,K));return U.set(O,{of:G,item:dt,state:q,look:H,more:et,track:ct,forget:K}),U.get(O)},z=()=>{l.textContent=d.map(([q,H])=>`${ri(q,s())}: ${H}`).join(", ");let O=f.names().slice(0,64);for(let q of U.keys())O.includes(q)||U.delete(q);let P=O.map(L),G=Ay(t.command("request")||(h?"":"no eyes are present"),d,s());E.set("Connect",[v],G.connect),E.set("Disconnect",[A],G.disconnect),E.set("End track",[S],G.end),E.set("Training",[R.training],G.train),E.set("Add sample",P.map(({more:q})=>q),G.train),E.set("Find",P.map(({look:q})=>q),G.find),E.set("Track",P.map(({track:q})=>q),G.track),E.set("Forget",P.map(({forget:q})=>q),G.forget),cl(x,P.map(({item:q})=>q)),N()};f.onChange(z),t.onChange(z),n.follow("eyes","(vision-mode ?eyes ?mode ?connected)",([O])=>{h=!!O,u=O?Y(O[1]):u;let P=O?Y(O[2]):"no eyes";a.textContent=O?`${u}: ${P}`:P,a.className=`chip ${h?P==="idle"?"":"busy":"bad"}`,document.body.dataset.eyes=P,z()}),n.follow("eyes","(vision-held ?eyes ?client ?mode)",O=>{d=O.map(P=>[Y(P[2]),Y(P[3])]),z()}),n.follow("eyes","(tracked ?eyes ?name ?state ?frame ?confidence)",O=>{T.clear();for(let P of O)T.set(Y(P[2]),P);N()}),n.follow("eyes","(look ?eyes ?frame ?text ?of)",([O])=>{c.hidden=!O,O&&(c.textContent=$t(Y(O[3]),1e3))})}var Ry=4,Py=60;function qp(i){let[,,t,e,n,s,r]=ht(i);return[t,{text:te(e),teller:n,when:s,because:r}]}async function Iy(i,t,e){let n=[zt("provenance"),t,...["?id","?fact","?teller","?when","?because"].map(zt)],s=new Map((await i.ask(n)).map(qp));if(s.set(t,e),![...s.values()].some(({because:a})=>a.some(l=>!s.has(l))))return s;let o=await i.askThen(te(n),e.when).catch(()=>[]);for(let[a,l]of o.map(qp))s.has(a)||s.set(a,{...l,gone:!0});return s}function Ly(i,t){if(!t)return C("span",{class:"fact gone"},`fact ${i}, which is not there any more`);let e=t.gone?", gone since":"";return C("span",{class:t.gone?"fact gone":"fact"},C("code",{},$t(t.text,120)),C("small",{class:"quiet"},`fact ${i}, by ${t.teller} at ${We(t.when)}${e}`))}function $p(i,t,e,n,s){n.push(i);let o=(t&&s<Ry?t.because:[]).slice(0,Math.max(0,Py-n.length)).map(l=>$p(l,e.get(l),e,n,s+1)),a=o.length?C("ul",{"aria-label":"because of"},...o):null;return C("li",{},Ly(i,t),a)}async function Au(i,t,e){let n=await Iy(i,t,e);return C("ul",{class:"provenance","aria-label":"Because of what it was told"},$p(t,e,n,[],0))}function Yp(i,t,e){if(e.because.length===0)return null;let n=C("div",{}),s=`Because of ${e.because.length} fact${e.because.length>1?"s":""}`,r=C("button",{type:"button",class:"because"},s);return r.addEventListener("click",async()=>{r.disabled=!0,n.replaceChildren(await Au(i,t,e)),r.disabled=!1}),C("div",{},r,n)}var Wr=(i,{teller:t,when:e})=>`fact ${i}, told by ${t} at ${We(e)}`;var Dy=60,Ny=["Relation","Facts","Told/s","Watches","To board","To watcher","Told by"],Zp=i=>(i/1e3).toFixed(i<1e4?1:0),Jp=i=>i?`${Zp(i.p50)} / ${Zp(i.p99)}`:"\u2013";function Uy({revision:i,facts:t,transactions_per_second:e,journey:n}){let s=n?`; a fact is committed after ${n.committed_us} \xB5s, acknowledged after ${n.acknowledged_us} \xB5s, delivered after ${n.delivered_us} \xB5s`:"";return`revision ${i}, ${t} facts, ${e.toFixed(1)} transactions/s${s}`}function Kp(i,t,e){let n=C("p",{class:"quiet",id:"activity-note"},"\u2026"),s=Li({id:"relations"},Ny),r=new Map,o=c=>(r.has(c)||r.set(c,C("button",{type:"button",class:"small",onclick:()=>e(c)},c)),r.get(c).disabled=!t(c),r.get(c)),a=(c,f)=>{if(!c){n.textContent=f??"";return}n.textContent=Uy(c);let u=c.relations.filter(h=>h.facts||h.told_per_second||h.watches).slice(0,Dy);s.fill(u.toSorted((h,d)=>h.name.localeCompare(d.name)).map(h=>[o(h.name),h.facts,h.told_per_second.toFixed(1),h.watches,Jp(h.told_us),Jp(h.delivered_us),h.tellers.join(" ")]))},l=C("section",{"aria-label":"Relations"},C("h2",{},"Relations"),n,C("p",{class:"quiet"},"Under way to the board and from there, in ms: the half / 99 %. A name that is off stands in no contract, so its form is not known."),C("div",{class:"scroll",tabindex:0,role:"group","aria-label":"Table of relations"},s.panel));return i.shownIn(l,a),l}var Ll=200,Fy=i=>`(${Y(i[1])}${i[2].map(t=>` ?${Y(t[0])}`).join("")})`;function Oy(i,t){if(i.length===0)return C("p",{class:"quiet"},"nothing, now");let e=Object.keys(i[0].bindings),n=C("tr",{},...(e.length?e:["fact"]).map(r=>C("th",{},r)),C("td",{})),s=i.slice(0,Ll).map(r=>{let o=r.facts.map((l,c)=>Wr(r.ids[c],l)),a=e.length?e.map(l=>r.bindings[l]??""):[r.facts[0]?.text??"yes"];return C("tr",{title:o.join(`
`),class:t(r)?"new":""},...a.map(l=>C("td",{},$t(l,160))),C("td",{},C("button",{type:"button",class:"because","data-ids":r.ids.join()},"Because \u2026")))});return C("table",{},C("thead",{},n),C("tbody",{},...s))}function jp(i,t){let e=C("input",{id:"query",spellcheck:"false",list:"questions",placeholder:"(on ?x ?y)","aria-label":"Question"}),n=C("datalist",{id:"questions"}),s=C("span",{class:"quiet",id:"query-count"}),r=C("pre",{class:"answer bad",id:"query-wrong",hidden:!0}),o=C("div",{class:"scroll",id:"answers"}),a=C("form",{class:"row"},e,n,C("button",{type:"submit",class:"strong"},"Watch"),s),l=C("div",{id:"because",role:"group","aria-label":"Reasons",tabindex:0,hidden:!0}),c=new Map,f=Kp(t,p=>c.has(p),p=>{e.value=c.get(p)??"",a.requestSubmit()});bt("facts").append(a,r,l,o,f);let u=[],h=async p=>{let g=(p.target instanceof Element?p.target.closest("button.because"):null)?.getAttribute("data-ids"),m=u.find(A=>A.ids.join()===g);if(!m)return;let v=m.facts.map((A,S)=>Au(i,m.ids[S],A));l.replaceChildren(...await Promise.all(v)),l.hidden=!1};o.addEventListener("pointerdown",h),o.addEventListener("keydown",p=>["Enter"," "].includes(p.key)&&h(p));let d=()=>{};a.addEventListener("submit",p=>{p.preventDefault(),d(),r.hidden=!0,s.textContent="",o.replaceChildren(),l.hidden=!0;let _=[],g=0,m=new Set,v=ii(()=>{let A=_.length+g>Ll?`, ${Ll} shown`:"";s.textContent=`${_.length+g} answer${_.length+g===1?"":"s"}${A}`,u=_;let S=m;m=new Set(_.slice(0,Ll).map(R=>R.ids.join())),o.replaceChildren(Oy(_,R=>S.size>0&&!S.has(R.ids.join())))});d=i.watch(e.value,(A,S)=>{_=A,g=S.resynchronised?S.cut:g+S.cut,v()},A=>{r.hidden=!1,r.textContent=Te(A)})}),i.follow("(contract ?name ?form)",p=>{let g=p.flatMap(m=>ht(m)[2]).filter(m=>Array.isArray(m)&&Y(m[0])==="posts").flatMap(m=>m.slice(1)).filter(m=>Array.isArray(m?.[2]));c.clear();for(let m of g)c.set(Y(m[1]),Fy(m));n.replaceChildren(...[...c.values()].sort().map(m=>C("option",{value:m})))})}function Qp(i){let t=bt("hands-note"),e=C("span",{}),n=C("button",{type:"button"});t.append(e,n);let s=()=>{};n.addEventListener("click",()=>s());let r=(c,f,u)=>{t.hidden=c==="",e.textContent!==c&&(e.textContent=c),n.textContent=f,s=u},o=()=>i.toggle().catch(c=>e.textContent=Te(c)),a=()=>{i.change=null,l()},l=()=>{let{change:c,mine:f}=i,[u]=i.askers;return c&&!c.to?r("You no longer have the arm in hand.","OK",a):c&&c.to!=="you"?r(`${c.to} has taken the arm over.`,"OK",a):f&&u?r(`${u} asks for the arm.`,`Let ${u} have it`,o):c&&f?r(`You have taken the arm over from ${c.from}, who is told.`,"OK",a):r("","",()=>{})};i.onChange(l)}var tm=[{name:"pan",label:"Pan left / right",index:1},{name:"tilt",label:"Tilt down / up",index:2}];function ky({name:i,label:t},e){let n=Tl({label:t,unit:"\xB0",most:30,form:c=>`(set-${i}-rel-pos ${c})`},e),s=Jo({label:`${t.split(" ")[0]} speed`,unit:"%",least:1,most:100,value:20,form:c=>`(set-${i}-speed ${c})`},e),r=C("input",{type:"number",id:`${i}-place`,step:"any",required:!0,size:6,"aria-label":`${i} to, degrees`}),o=C("button",{type:"submit"},"Move to"),a=C("button",{type:"button",onclick:()=>e(`(reset-${i})`)},`Reset ${i}`),l=C("form",{class:"row"},C("label",{for:r.id},i),r,"\xB0",o,a);return l.addEventListener("submit",c=>{c.preventDefault(),e(`(set-${i}-pos ${Number(r.value)})`)}),{rows:[n.row,s.row],form:l,percent:s,controls:[n.input,s.input,r,o,a]}}function zy(i,t){let[,,,,e,n,s]=i,r=o=>Math.atan(o/e)*180/Math.PI;return{pan:r(t.x-n),tilt:-r(t.y-s)}}function em(i,t,e,n){let s=bt("head"),r=new Vr(i,()=>"pan-tilt",n,"Commands that the head received, newest first"),o=A=>r.send(A),a=C("span",{id:"head-light",class:"chip"},"no head is present"),l=C("output",{"aria-label":"Where the head looks"},""),c=tm.map(A=>ky(A,o)),f=(A,S)=>C("button",{type:"button",onclick:()=>o(S)},A),u=[f("Connect","(pt-init)"),f("Disconnect","(pt-close)"),f("Reset both","(reset-all)"),f("Look ahead","(look-ahead)")],h=C("input",{type:"checkbox",id:"click-to-look"}),d=[...u,h,...c.flatMap(A=>A.controls)],p=new Mn("why-head");s.append(C("div",{class:"row"},a,l,...u),p.note,C("div",{class:"slides"},...c.flatMap(A=>A.rows)),...c.map(A=>A.form),C("label",{class:"row"},h,"A click in the camera\u2019s image turns the head there"),C("h2",{},"Commands received"),r.list);let _,g;e.onPoint(A=>{if(!h.checked||!_||!g)return!1;let S=zy(g,A);return o(`(set-pan-pos ${(_[1]+S.pan).toFixed(2)})`),o(`(set-tilt-pos ${(_[2]+S.tilt).toFixed(2)})`),!0}),i.follow("(head ?pan ?tilt ?state)",A=>{_=A.length?ht(A[0]):void 0,l.textContent=_?`pan ${_[1].toFixed(1)}\xB0, tilt ${_[2].toFixed(1)}\xB0, ${Y(_[3])}`:""}),i.follow("(camera-model ?eyes ?width ?height ?focal ?cx ?cy ?base)",A=>{let S=A.length?ht(A[0]):void 0;g=S&&[...S]});let m,v=()=>{let A=m?Y(m[1]):"no head is present";a.textContent=m&&Y(m[2])?`${A}: ${Y(m[2])}`:A,a.className=`chip ${A==="ready"?"good":"bad"}`;let S=m?"":"This cell has no head that turns, or its agent is away";p.set("Whatever turns the head",d,t.command("request")||S)};t.onChange(v),i.follow("(pan-tilt ?state ?trouble)",A=>{m=A.length?ht(A[0]):void 0,v()}),i.follow("(head-speed ?pan ?tilt)",A=>{A.length&&tm.forEach((S,R)=>c[R].percent.put(ht(A[0])[S.index]))})}function nm(i){let t=location.protocol==="https:";bt("refused-here").hidden=t,bt("log-in").hidden=!t,bt("log-out").hidden=!t,bt("log-out").addEventListener("click",()=>i.logOut());let e=!1;return bt("log-in").addEventListener("submit",n=>{n.preventDefault(),e=!0,bt("log-in-wrong").textContent="",i.logIn(bt("token").value.trim()),bt("token").value=""}),(n,s="")=>{n==="live"&&(e=!1,bt("refused").close()),n==="refused"&&(bt("log-in-wrong").textContent=e?"This token is wrong.":s),n==="refused"&&!bt("refused").open&&bt("refused").showModal()}}var Vy={closed:"the camera is closed: Connect, in Eyes, opens it",opening:"the camera opens",lost:"the camera is lost"},im=[{kinds:["colour","left"],title:"Camera"},{kinds:["annotated"],title:"What the eyes follow"}];function Gy(i){let t=C("canvas",{width:640,height:480,role:"img","aria-label":i}),e=C("span",{class:"quiet"},"no eyes are present"),n=C("figure",{class:"card"},t,C("figcaption",{},C("span",{},i),e));return{canvas:t,note:e,card:n,stream:"",shown:null,end:()=>{}}}function Dl(i,t){(i.width!==t.width||i.height!==t.height)&&(i.width=t.width,i.height=t.height),ji(i).drawImage(t.bitmap,0,0,t.width,t.height)}function Hy(i,t){let{canvas:e}=i;Dl(e,t),i.shown={number:t.number,width:t.width,height:t.height},i.note.textContent=`frame ${t.number}`,e.dataset.captured=String(t.captured),e.dataset.frame=String(t.number)}async function Wy(i,t,e,n){t.shown=null,t.note.textContent="looking for what was kept \u2026";try{let s=await i.picture(t.stream,e);n()&&(Dl(t.canvas,s),t.note.textContent=`frame ${s.number}, ${We(s.captured)}`),s.bitmap.close()}catch(s){if(!n())return;ji(t.canvas).clearRect(0,0,t.canvas.width,t.canvas.height),t.note.textContent=Te(s)}}function Xy(i,t){if(!i.shown)return null;let{width:e,height:n,number:s}=i.shown,r=i.canvas.getBoundingClientRect(),o=Math.min(r.width/e,r.height/n),a=Math.round((t.clientX-r.left-(r.width-o*e)/2)/o),l=Math.round((t.clientY-r.top-(r.height-o*n)/2)/o);return a>=0&&l>=0&&a<e&&l<n?{x:a,y:l,frame:s}:null}function sm(i,t){let e=im.map(h=>Gy(h.title));bt("images").append(...e.map(h=>h.card));let n=null,s=[],r=h=>{let d=s.filter(p=>Y(p[2])===h).map(p=>Y(p[1]));return d.find(p=>p===`${t.server("eyes")}-${h}`)??d[0]},o=()=>im.forEach((h,d)=>{let p=e[d],_=h.kinds.map(r).find(Boolean)??"";_!==p.stream&&(p.end(),p.stream=_,p.canvas.dataset.stream=_,p.end=_?i.look(_,g=>n===null&&Hy(p,g)):()=>{},_||(p.note.textContent="no such stream"))});i.followAlways("(stream ?name ?kind ?place)",h=>{s=h.map(ht),o()}),t.onChange(o),i.followAlways("(camera-state ?eyes ?state ?trouble)",h=>{let d=h.map(ht),[,,p,_]=d.find(v=>Y(v[1])===t.server("eyes"))??d[0]??[],g=p===void 0?"no eyes are present":Vy[Y(p)];if(n!==null)return;let m=$t([g,Y(_??"")].filter(Boolean).join(": "),120);for(let v of e)(g||!v.shown)&&(v.note.textContent=g?m:"no image yet")});let a=[],[l]=e;return l.canvas.classList.add("clickable"),l.canvas.addEventListener("click",h=>{let d=Xy(l,h);d&&a.some(p=>p(d))}),{onPoint:h=>a.push(h),showMoment:h=>{n=h;let d=()=>n===h;for(let p of e)h!==null&&p.stream&&Wy(i,p,h,d)},telling:()=>e[1].stream||e[0].stream}}var qy={connecting:"connecting",live:"live",silent:"silent",lost:"no connection",refused:"no session"},$y=["want","eyes","drive","head"];function rm(i){let t=bt("state");return(e,n="")=>{let s=e==="live",r=[qy[e],$t(n,160)].filter(Boolean).join(e==="silent"?" ":": ");t.textContent!==r&&(t.textContent=r),t.className=`chip ${s?"good":"bad"}`,document.body.dataset.state=e,e!=="connecting"&&(bt("line-note").hidden=s);for(let o of $y)bt(o).inert=!s;i.set({live:s})}}var Nl=class{#e=!1;#t=!1;#n={};#i=[];set({live:t=this.#e,past:e=this.#t,mayNot:n=this.#n}){this.#e=t,this.#t=e,this.#n=n;for(let s of this.#i)s()}onChange(t){this.#i.push(t),t()}get live(){return this.#e}get line(){return this.#e?"":"There is no live line to the console"}get past(){return this.#t?"You look at the past: press Now first":""}right(...t){return t.map(e=>this.#n[e]).find(Boolean)??""}command(...t){return this.line||this.right(...t)||this.past}};var Yy=/^\s*(\d{1,2}):(\d{2})(?::(\d{2}))?\s*$/,om=i=>[i.getFullYear(),i.getMonth()+1,i.getDate()].map(t=>String(t).padStart(2,"0")).join("-"),Xr=()=>om(new Date),jo=i=>om(new Date(i/1e3)),cr=i=>jo(i)===Xr()?We(i):`${jo(i)} ${We(i)}`;function Zy(i,t,e){let[,n,s,r]=i.match(Yy)?.map(Number)??[];if(n===void 0||n>23||s>59||r>59)return{wrong:"write a time as 14:03 or 14:03:20"};let[o,a,l]=(t||Xr()).split("-").map(Number),c=new Date(o,a-1,l,n,s,r||0).getTime()*1e3;return c>Date.now()*1e3?{wrong:`${cr(c)} is yet to come`}:c<e?{wrong:`nothing is known from before ${cr(e)}`}:{moment:c}}var Ul=class{#e=0;#t=!1;#n=C("input",{id:"moment-time",size:8,maxlength:8,placeholder:"hh:mm:ss",spellcheck:"false","aria-label":"Time of day"});#i=C("input",{id:"moment-date",type:"date","aria-label":"Day",hidden:!0});#s=C("button",{type:"submit"},"Go to");controls=[this.#n,this.#i,this.#s];form=C("form",{class:"row",autocomplete:"off"},this.#i,this.#n,this.#s);constructor(t){this.form.addEventListener("submit",e=>{e.preventDefault();let n=Zy(this.#n.value,this.#i.value,this.#e);if(this.#n.setCustomValidity("wrong"in n?n.wrong:""),!("moment"in n))return this.#n.reportValidity();this.#t=!1,t(n.moment)}),this.#n.addEventListener("input",()=>{this.#t=!0,this.#n.setCustomValidity("")}),this.#n.addEventListener("blur",()=>this.#t=!1)}since(t){this.#e=t,this.#i.hidden=jo(t)===Xr(),this.#i.min=jo(t),this.#i.max=Xr(),this.#i.value||(this.#i.value=Xr())}show(t){this.#t||document.activeElement===this.#i||(this.#n.value=t===null?"":We(t),this.#i.value=t===null?Xr():jo(t))}};var Cu=1e6,Jy=1e3;function Ky(i){let t=(e,n,s)=>C("button",{type:"button","aria-label":s,title:s,onclick:()=>i(e)},n);return[t(-1,"\u25C2 Entry","The entry of the story before"),t(1,"Entry \u25B8","The entry of the story after")]}var Ru=class{#e;#t=0;#n=0;#i=!1;#s="";#r=C("input",{type:"range",id:"moment",min:0,max:1,step:1,value:1,"aria-label":"Back in time, by seconds"});#o=C("output",{id:"moment-note",for:"moment"},"now");#a=C("button",{type:"button",id:"back-to-now",disabled:!0,onclick:()=>this.goTo(null)},"Now");#l=new Ul(t=>this.goTo(t));#c=Ky(t=>this.#p(t));#h=new Mn("why-no-past");constructor(t){this.#e=t;let{connection:e,permission:n}=t;bt("past").append(C("label",{for:"moment"},"Time"),this.#r,...this.#c,this.#l.form,this.#o,this.#a,this.#h.note),this.#r.addEventListener("input",()=>this.#o.textContent=cr(this.#f()??Date.now()*1e3)),this.#r.addEventListener("change",()=>this.goTo(this.#f())),this.#r.addEventListener("keydown",s=>this.#_(s)),e.followAlways("(agent ?name ?kind ?host)",s=>this.#g(s)),e.followAlways("(event ?n ?kind ?sentence ?detail)",s=>this.#g(s)),n.onChange(()=>this.#m()),setInterval(()=>this.#u(),Jy)}async goTo(t){let{connection:e,permission:n,images:s}=this.#e;document.body.classList.toggle("past",t!==null),n.set({past:t!==null}),this.#a.disabled=t===null,this.#o.textContent=t===null?"now":`${cr(t)} \u2026`,this.#d(t),s.showMoment(t);let r=await e.showMoment(t);t===null||e.moment!==t||(this.#o.textContent=r?Te(r):`as it was at ${cr(t)}`)}#f(){let t=Number(this.#r.value);return t===Number(this.#r.max)?null:this.#t+t*Cu}#d(t){let e=Math.max(1,Math.ceil((Date.now()*1e3-this.#t)/Cu));this.#r.max=String(e),this.#r.value=String(t===null?e:Math.min(Math.max(Math.round((t-this.#t)/Cu),0),e-1)),this.#r.setAttribute("aria-valuetext",t===null?"now":cr(t)),this.#l.show(t)}#u(){this.#r.matches(":active")||this.#d(this.#e.connection.moment)}#p(t){let{connection:e,entries:n}=this.#e,s=e.moment??1/0,r=n.until(1/0).map(({facts:a})=>a[0].when),o=t<0?r.findLast(a=>a<s):r.find(a=>a>s);(o!==void 0||t>0)&&this.goTo(o??null)}#_(t){t.key!=="PageUp"&&t.key!=="PageDown"||(t.preventDefault(),this.#p(t.key==="PageUp"?1:-1))}#g(t){let e=t.map(({facts:n})=>n[0].when);e.length!==0&&(this.#t=Math.min(this.#t||1/0,...e),this.#n=Math.max(this.#n,...e),this.#l.since(this.#t),this.#m())}async#x(){this.#i=!0;try{await this.#e.connection.askThen("(agent ?name ?kind ?host)",this.#n),this.#s=""}catch(t){this.#s=t.sentence??Te(t)}this.#m()}#m(){let{permission:t}=this.#e;t.live?!this.#i&&this.#n&&this.#x():this.#i=!1;let e=t.line||(this.#n?this.#s:"nothing is known yet");this.#h.set("Back in time",[this.#r,...this.#c,...this.#l.controls],e)}};function am(i){let t=new Ru(i);return e=>t.goTo(e)}function jy(i,t){let e=Array.from({length:i.length+1},()=>Array(t.length+1).fill(0));for(let o=i.length-1;o>=0;--o)for(let a=t.length-1;a>=0;--a)e[o][a]=i[o]===t[a]?e[o+1][a+1]+1:Math.max(e[o+1][a],e[o][a+1]);let n=[],s=0,r=0;for(;s<i.length||r<t.length;)s<i.length&&r<t.length&&i[s]===t[r]?n.push([i[s++],t[r++]]):r===t.length||s<i.length&&e[s+1][r]>=e[s][r+1]?n.push([i[s++],null]):n.push([null,t[r++]]);return n}function lm(i,t,e){let n=(r,o,a)=>C("td",{class:r?o:""},r&&C("code",{},$t(r,80)),r&&a&&C("small",{},` ${a}`)),s=jy(i.map(te),t.map(te)).map(([r,o])=>C("tr",{},n(r,o?"kept":"dropped",o?"":e.has(r??"")?"begun":"dropped"),n(o,r?"kept":"made",r?"kept":"new")));return C("table",{class:"plans"},C("thead",{},C("tr",{},C("th",{},"The plan before"),C("th",{},"From here on"))),C("tbody",{},...s))}function gs(i){if(!Array.isArray(i)||Y(i[0])!=="plan")return null;let[,t,e]=i;return Array.isArray(e)?{goal:t,operations:e}:null}var Qy=(i,t)=>t.every((e,n)=>e===i[i.length-t.length+n]);function tv(i,t,e){let n=e.findLastIndex(s=>{let r=gs(s[4]);return r!==null&&r.goal===i&&r.operations.map(te).join()===t.join()});return e.slice(n+1)}function cm(i,t,e){let[,n,s]=i,r=s.map(te),o=new Set,a=new Set,l=1/0;for(let[,,u,,h]of tv(n,r,e.map(ht))){let d=gs(h)?.operations.map(te);if(Y(u)==="operation")o.add(te(h));else if(d&&d.length<r.length&&Qy(r,d)){l=r.length-d.length;for(let p of r.slice(l))for(let _ of[o,a])_.delete(p)}else if(Y(u)==="difference"&&Array.isArray(h))for(let p of h.map(te))r.includes(p)&&a.add(p)}let c=t&&ht(t),f=c&&te(c[2])===r[c[1]];return r.map((u,h)=>f&&h===c[1]?Y(c[3]):f&&h<c[1]?a.has(u)?"skipped":"done":a.has(u)?"skipped":h>=l?"still serves":"")}var ev={"still serves":"serves"};function nv(i,t){let e=bt("plan");if(e.replaceChildren(),bt("plan-note").textContent=i?`for goal ${i[1]}`:"none yet",!i)return;i[2].forEach((s,r)=>{let o=t[r],a=C("li",{class:ev[o]??o},C("code",{},$t(te(s),80)));o&&a.append(C("span",{class:"mark"},o)),o==="running"&&a.setAttribute("aria-current","step"),e.append(a)});let n=e.querySelector(".running");n instanceof HTMLElement&&(e.scrollTop=n.offsetTop-e.offsetTop-e.clientHeight/2)}function hm(i,t){let e,n,s=ii(()=>{let r=t.until(i.moment??1/0);nv(e,e?cm(e,n,r):[])});t.onChange(s),i.follow("(plan ?n ?operations)",r=>{e=r.length?ht(r[0]):void 0,s()}),i.follow("(operation ?i ?operation ?state)",r=>{n=r[0],s()})}/**
 * @license
 * Copyright 2010-2026 Three.js Authors
 * SPDX-License-Identifier: MIT
 */var Js={LEFT:0,MIDDLE:1,RIGHT:2,ROTATE:0,DOLLY:1,PAN:2},Ks={ROTATE:0,PAN:1,DOLLY_PAN:2,DOLLY_ROTATE:3},Gm=0,af=1,Hm=2;var Oa=1,Wm=2,bo=3,js=0,ei=1,oi=2,xr=0,wo=1,lf=2,cf=3,hf=4,Xm=5;var yr=100,qm=101,$m=102,Ym=103,Zm=104,Jm=200,Km=201,jm=202,Qm=203,uf=204,ff=205,tg=206,eg=207,ng=208,ig=209,sg=210,rg=211,og=212,ag=213,lg=214,fc=0,dc=1,pc=2,uo=3,mc=4,gc=5,_c=6,xc=7,df=0,cg=1,hg=2,as=0,pf=1,mf=2,gf=3,_f=4,xf=5,yf=6,vf=7;var Sf=300,vr=301,To=302,Xc=303,qc=304,yc=1e3,es=1001,vc=1002,Un=1003,ug=1004;var Ba=1005;var jn=1006,$c=1007;var Es=1008;var ai=1009,Mf=1010,bf=1011,Eo=1012,Yc=1013,Bi=1014,ki=1015,zi=1016,Zc=1017,Jc=1018,Sr=1020,wf=35902,Tf=35899,Ef=1021,Af=1022,Vi=1023,bs=1026,As=1027,Cf=1028,Kc=1029,Qs=1030,jc=1031;var Qc=1033,ka=33776,za=33777,Va=33778,Ga=33779,th=35840,eh=35841,nh=35842,ih=35843,sh=36196,rh=37492,oh=37496,ah=37488,lh=37489,Ha=37490,ch=37491,hh=37808,uh=37809,fh=37810,dh=37811,ph=37812,mh=37813,gh=37814,_h=37815,xh=37816,yh=37817,vh=37818,Sh=37819,Mh=37820,bh=37821,wh=36492,Th=36494,Eh=36495,Ah=36283,Ch=36284,Wa=36285,Rh=36286;var ca=2300,Sc=2301,hc=2302,Qu=2303,tf=2400,ef=2401,nf=2402;var fg=3200;var Ph=0,dg=1,Cs="",Jn="srgb",ha="srgb-linear",ua="linear",Le="srgb";var uc=7680;var pg=519,mg=512,gg=513,_g=514,Rf=515,xg=516,yg=517,Pf=518,If=519,Lf=35044;var Df="300 es",Ti=2e3,fo=2001;function iv(i){for(let t=i.length-1;t>=0;--t)if(i[t]>=65535)return!0;return!1}function sv(i){return ArrayBuffer.isView(i)&&!(i instanceof DataView)}function fa(i){return document.createElementNS("http://www.w3.org/1999/xhtml",i)}function vg(){let i=fa("canvas");return i.style.display="block",i}var um={},po=null;function da(...i){let t="THREE."+i.shift();po?po("log",t,...i):console.log(t,...i)}function Sg(i){let t=i[0];if(typeof t=="string"&&t.startsWith("TSL:")){let e=i[1];e&&e.isStackTrace?i[0]+=" "+e.getLocation():i[1]='Stack trace not available. Enable "THREE.Node.captureStackTrace" to capture stack traces.'}return i}function jt(...i){i=Sg(i);let t="THREE."+i.shift();if(po)po("warn",t,...i);else{let e=i[0];e&&e.isStackTrace?console.warn(e.getError(t)):console.warn(t,...i)}}function se(...i){i=Sg(i);let t="THREE."+i.shift();if(po)po("error",t,...i);else{let e=i[0];e&&e.isStackTrace?console.error(e.getError(t)):console.error(t,...i)}}function aa(...i){let t=i.join(" ");t in um||(um[t]=!0,jt(...i))}function Mg(i,t,e){return new Promise(function(n,s){function r(){switch(i.clientWaitSync(t,i.SYNC_FLUSH_COMMANDS_BIT,0)){case i.WAIT_FAILED:s();break;case i.TIMEOUT_EXPIRED:setTimeout(r,e);break;default:n()}}setTimeout(r,e)})}var bg={[fc]:fc,[pc]:_c,[mc]:mc,[uo]:gc,[dc]:dc,[_c]:pc,[xc]:xc,[gc]:uo},Oi=class{addEventListener(t,e){this._listeners===void 0&&(this._listeners={});let n=this._listeners;n[t]===void 0&&(n[t]=[]),n[t].indexOf(e)===-1&&n[t].push(e)}hasEventListener(t,e){let n=this._listeners;return n===void 0?!1:n[t]!==void 0&&n[t].indexOf(e)!==-1}removeEventListener(t,e){let n=this._listeners;if(n===void 0)return;let s=n[t];if(s!==void 0){let r=s.indexOf(e);r!==-1&&s.splice(r,1)}}dispatchEvent(t){let e=this._listeners;if(e===void 0)return;let n=e[t.type];if(n!==void 0){t.target=this;let s=n.slice(0);for(let r=0,o=s.length;r<o;r++)s[r].call(this,t);t.target=null}}},Vn=["00","01","02","03","04","05","06","07","08","09","0a","0b","0c","0d","0e","0f","10","11","12","13","14","15","16","17","18","19","1a","1b","1c","1d","1e","1f","20","21","22","23","24","25","26","27","28","29","2a","2b","2c","2d","2e","2f","30","31","32","33","34","35","36","37","38","39","3a","3b","3c","3d","3e","3f","40","41","42","43","44","45","46","47","48","49","4a","4b","4c","4d","4e","4f","50","51","52","53","54","55","56","57","58","59","5a","5b","5c","5d","5e","5f","60","61","62","63","64","65","66","67","68","69","6a","6b","6c","6d","6e","6f","70","71","72","73","74","75","76","77","78","79","7a","7b","7c","7d","7e","7f","80","81","82","83","84","85","86","87","88","89","8a","8b","8c","8d","8e","8f","90","91","92","93","94","95","96","97","98","99","9a","9b","9c","9d","9e","9f","a0","a1","a2","a3","a4","a5","a6","a7","a8","a9","aa","ab","ac","ad","ae","af","b0","b1","b2","b3","b4","b5","b6","b7","b8","b9","ba","bb","bc","bd","be","bf","c0","c1","c2","c3","c4","c5","c6","c7","c8","c9","ca","cb","cc","cd","ce","cf","d0","d1","d2","d3","d4","d5","d6","d7","d8","d9","da","db","dc","dd","de","df","e0","e1","e2","e3","e4","e5","e6","e7","e8","e9","ea","eb","ec","ed","ee","ef","f0","f1","f2","f3","f4","f5","f6","f7","f8","f9","fa","fb","fc","fd","fe","ff"],fm=1234567,co=Math.PI/180,mo=180/Math.PI;function tr(){let i=Math.random()*4294967295|0,t=Math.random()*4294967295|0,e=Math.random()*4294967295|0,n=Math.random()*4294967295|0;return(Vn[i&255]+Vn[i>>8&255]+Vn[i>>16&255]+Vn[i>>24&255]+"-"+Vn[t&255]+Vn[t>>8&255]+"-"+Vn[t>>16&15|64]+Vn[t>>24&255]+"-"+Vn[e&63|128]+Vn[e>>8&255]+"-"+Vn[e>>16&255]+Vn[e>>24&255]+Vn[n&255]+Vn[n>>8&255]+Vn[n>>16&255]+Vn[n>>24&255]).toLowerCase()}function ye(i,t,e){return Math.max(t,Math.min(e,i))}function Nf(i,t){return(i%t+t)%t}function rv(i,t,e,n,s){return n+(i-t)*(s-n)/(e-t)}function ov(i,t,e){return i!==t?(e-i)/(t-i):0}function la(i,t,e){return(1-e)*i+e*t}function av(i,t,e,n){return la(i,t,1-Math.exp(-e*n))}function lv(i,t=1){return t-Math.abs(Nf(i,t*2)-t)}function cv(i,t,e){return i<=t?0:i>=e?1:(i=(i-t)/(e-t),i*i*(3-2*i))}function hv(i,t,e){return i<=t?0:i>=e?1:(i=(i-t)/(e-t),i*i*i*(i*(i*6-15)+10))}function uv(i,t){return i+Math.floor(Math.random()*(t-i+1))}function fv(i,t){return i+Math.random()*(t-i)}function dv(i){return i*(.5-Math.random())}function pv(i){i!==void 0&&(fm=i);let t=fm+=1831565813;return t=Math.imul(t^t>>>15,t|1),t^=t+Math.imul(t^t>>>7,t|61),((t^t>>>14)>>>0)/4294967296}function mv(i){return i*co}function gv(i){return i*mo}function _v(i){return i>0&&Number.isInteger(i)&&2**Math.round(Math.log2(i))===i}function xv(i){return Math.pow(2,Math.ceil(Math.log(i)/Math.LN2))}function Uf(i){return Math.pow(2,Math.floor(Math.log(i)/Math.LN2))}function yv(i,t,e,n,s){let r=Math.cos,o=Math.sin,a=r(e/2),l=o(e/2),c=r((t+n)/2),f=o((t+n)/2),u=r((t-n)/2),h=o((t-n)/2),d=r((n-t)/2),p=o((n-t)/2);switch(s){case"XYX":i.set(a*f,l*u,l*h,a*c);break;case"YZY":i.set(l*h,a*f,l*u,a*c);break;case"ZXZ":i.set(l*u,l*h,a*f,a*c);break;case"XZX":i.set(a*f,l*p,l*d,a*c);break;case"YXY":i.set(l*d,a*f,l*p,a*c);break;case"ZYZ":i.set(l*p,l*d,a*f,a*c);break;default:jt("MathUtils: .setQuaternionFromProperEuler() encountered an unknown order: "+s)}}function Ih(i){switch(i.constructor){case Uint32Array:return 4294967295;case Uint16Array:return 65535;case Uint8Array:case Uint8ClampedArray:return 255;case Int32Array:return 2147483647;case Int16Array:return 32767;case Int8Array:return 127;default:return}}function Ff(i,t){if(t.constructor===Float32Array)return i;let e=Ih(t);if(e===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.max(i/e,-1)}function Of(i,t){if(t.constructor===Float32Array)return i;let e=Ih(t);if(e===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.round(i*e)}var Bf={DEG2RAD:co,RAD2DEG:mo,generateUUID:tr,clamp:ye,euclideanModulo:Nf,mapLinear:rv,inverseLerp:ov,lerp:la,damp:av,pingpong:lv,smoothstep:cv,smootherstep:hv,randInt:uv,randFloat:fv,randFloatSpread:dv,seededRandom:pv,degToRad:mv,radToDeg:gv,isPowerOfTwo:_v,ceilPowerOfTwo:xv,floorPowerOfTwo:Uf,setQuaternionFromProperEuler:yv,normalize:Of,denormalize:Ff},Jt=class{static{this.prototype.isVector2=!0}constructor(t=0,e=0){this.x=t,this.y=e}get width(){return this.x}set width(t){this.x=t}get height(){return this.y}set height(t){this.y=t}set(t,e){return this.x=t,this.y=e,this}setScalar(t){return this.x=t,this.y=t,this}setX(t){return this.x=t,this}setY(t){return this.y=t,this}setComponent(t,e){switch(t){case 0:this.x=e;break;case 1:this.y=e;break;default:throw new Error("THREE.Vector2: index is out of range: "+t)}return this}getComponent(t){switch(t){case 0:return this.x;case 1:return this.y;default:throw new Error("THREE.Vector2: index is out of range: "+t)}}clone(){return new this.constructor(this.x,this.y)}copy(t){return this.x=t.x,this.y=t.y,this}add(t){return this.x+=t.x,this.y+=t.y,this}addScalar(t){return this.x+=t,this.y+=t,this}addVectors(t,e){return this.x=t.x+e.x,this.y=t.y+e.y,this}addScaledVector(t,e){return this.x+=t.x*e,this.y+=t.y*e,this}sub(t){return this.x-=t.x,this.y-=t.y,this}subScalar(t){return this.x-=t,this.y-=t,this}subVectors(t,e){return this.x=t.x-e.x,this.y=t.y-e.y,this}multiply(t){return this.x*=t.x,this.y*=t.y,this}multiplyScalar(t){return this.x*=t,this.y*=t,this}divide(t){return this.x/=t.x,this.y/=t.y,this}divideScalar(t){return this.multiplyScalar(1/t)}applyMatrix3(t){let e=this.x,n=this.y,s=t.elements;return this.x=s[0]*e+s[3]*n+s[6],this.y=s[1]*e+s[4]*n+s[7],this}min(t){return this.x=Math.min(this.x,t.x),this.y=Math.min(this.y,t.y),this}max(t){return this.x=Math.max(this.x,t.x),this.y=Math.max(this.y,t.y),this}clamp(t,e){return this.x=ye(this.x,t.x,e.x),this.y=ye(this.y,t.y,e.y),this}clampScalar(t,e){return this.x=ye(this.x,t,e),this.y=ye(this.y,t,e),this}clampLength(t,e){let n=this.length();return this.divideScalar(n||1).multiplyScalar(ye(n,t,e))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this}negate(){return this.x=-this.x,this.y=-this.y,this}dot(t){return this.x*t.x+this.y*t.y}cross(t){return this.x*t.y-this.y*t.x}lengthSq(){return this.x*this.x+this.y*this.y}length(){return Math.sqrt(this.x*this.x+this.y*this.y)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)}normalize(){return this.divideScalar(this.length()||1)}angle(){return Math.atan2(-this.y,-this.x)+Math.PI}angleTo(t){let e=Math.sqrt(this.lengthSq()*t.lengthSq());if(e===0)return Math.PI/2;let n=this.dot(t)/e;return Math.acos(ye(n,-1,1))}distanceTo(t){return Math.sqrt(this.distanceToSquared(t))}distanceToSquared(t){let e=this.x-t.x,n=this.y-t.y;return e*e+n*n}manhattanDistanceTo(t){return Math.abs(this.x-t.x)+Math.abs(this.y-t.y)}setLength(t){return this.normalize().multiplyScalar(t)}lerp(t,e){return this.x+=(t.x-this.x)*e,this.y+=(t.y-this.y)*e,this}lerpVectors(t,e,n){return this.x=t.x+(e.x-t.x)*n,this.y=t.y+(e.y-t.y)*n,this}equals(t){return t.x===this.x&&t.y===this.y}fromArray(t,e=0){return this.x=t[e],this.y=t[e+1],this}toArray(t=[],e=0){return t[e]=this.x,t[e+1]=this.y,t}fromBufferAttribute(t,e){return this.x=t.getX(e),this.y=t.getY(e),this}rotateAround(t,e){let n=Math.cos(e),s=Math.sin(e),r=this.x-t.x,o=this.y-t.y;return this.x=r*n-o*s+t.x,this.y=r*s+o*n+t.y,this}random(){return this.x=Math.random(),this.y=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y}},Qn=class{constructor(t=0,e=0,n=0,s=1){this.isQuaternion=!0,this._x=t,this._y=e,this._z=n,this._w=s}static slerpFlat(t,e,n,s,r,o,a){let l=n[s+0],c=n[s+1],f=n[s+2],u=n[s+3],h=r[o+0],d=r[o+1],p=r[o+2],_=r[o+3];if(u!==_||l!==h||c!==d||f!==p){let g=l*h+c*d+f*p+u*_;g<0&&(h=-h,d=-d,p=-p,_=-_,g=-g);let m=1-a;if(g<.9995){let v=Math.acos(g),A=Math.sin(v);m=Math.sin(m*v)/A,a=Math.sin(a*v)/A,l=l*m+h*a,c=c*m+d*a,f=f*m+p*a,u=u*m+_*a}else{l=l*m+h*a,c=c*m+d*a,f=f*m+p*a,u=u*m+_*a;let v=1/Math.sqrt(l*l+c*c+f*f+u*u);l*=v,c*=v,f*=v,u*=v}}t[e]=l,t[e+1]=c,t[e+2]=f,t[e+3]=u}static multiplyQuaternionsFlat(t,e,n,s,r,o){let a=n[s],l=n[s+1],c=n[s+2],f=n[s+3],u=r[o],h=r[o+1],d=r[o+2],p=r[o+3];return t[e]=a*p+f*u+l*d-c*h,t[e+1]=l*p+f*h+c*u-a*d,t[e+2]=c*p+f*d+a*h-l*u,t[e+3]=f*p-a*u-l*h-c*d,t}get x(){return this._x}set x(t){this._x=t,this._onChangeCallback()}get y(){return this._y}set y(t){this._y=t,this._onChangeCallback()}get z(){return this._z}set z(t){this._z=t,this._onChangeCallback()}get w(){return this._w}set w(t){this._w=t,this._onChangeCallback()}set(t,e,n,s){return this._x=t,this._y=e,this._z=n,this._w=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._w)}copy(t){return this._x=t.x,this._y=t.y,this._z=t.z,this._w=t.w,this._onChangeCallback(),this}setFromEuler(t,e=!0){let n=t._x,s=t._y,r=t._z,o=t._order,a=Math.cos,l=Math.sin,c=a(n/2),f=a(s/2),u=a(r/2),h=l(n/2),d=l(s/2),p=l(r/2);switch(o){case"XYZ":this._x=h*f*u+c*d*p,this._y=c*d*u-h*f*p,this._z=c*f*p+h*d*u,this._w=c*f*u-h*d*p;break;case"YXZ":this._x=h*f*u+c*d*p,this._y=c*d*u-h*f*p,this._z=c*f*p-h*d*u,this._w=c*f*u+h*d*p;break;case"ZXY":this._x=h*f*u-c*d*p,this._y=c*d*u+h*f*p,this._z=c*f*p+h*d*u,this._w=c*f*u-h*d*p;break;case"ZYX":this._x=h*f*u-c*d*p,this._y=c*d*u+h*f*p,this._z=c*f*p-h*d*u,this._w=c*f*u+h*d*p;break;case"YZX":this._x=h*f*u+c*d*p,this._y=c*d*u+h*f*p,this._z=c*f*p-h*d*u,this._w=c*f*u-h*d*p;break;case"XZY":this._x=h*f*u-c*d*p,this._y=c*d*u-h*f*p,this._z=c*f*p+h*d*u,this._w=c*f*u+h*d*p;break;default:jt("Quaternion: .setFromEuler() encountered an unknown order: "+o)}return e===!0&&this._onChangeCallback(),this}setFromAxisAngle(t,e){let n=e/2,s=Math.sin(n);return this._x=t.x*s,this._y=t.y*s,this._z=t.z*s,this._w=Math.cos(n),this._onChangeCallback(),this}setFromRotationMatrix(t){let e=t.elements,n=e[0],s=e[4],r=e[8],o=e[1],a=e[5],l=e[9],c=e[2],f=e[6],u=e[10],h=n+a+u;if(h>0){let d=.5/Math.sqrt(h+1);this._w=.25/d,this._x=(f-l)*d,this._y=(r-c)*d,this._z=(o-s)*d}else if(n>a&&n>u){let d=2*Math.sqrt(1+n-a-u);this._w=(f-l)/d,this._x=.25*d,this._y=(s+o)/d,this._z=(r+c)/d}else if(a>u){let d=2*Math.sqrt(1+a-n-u);this._w=(r-c)/d,this._x=(s+o)/d,this._y=.25*d,this._z=(l+f)/d}else{let d=2*Math.sqrt(1+u-n-a);this._w=(o-s)/d,this._x=(r+c)/d,this._y=(l+f)/d,this._z=.25*d}return this._onChangeCallback(),this}setFromUnitVectors(t,e){let n=t.dot(e)+1;return n<1e-8?(n=0,Math.abs(t.x)>Math.abs(t.z)?(this._x=-t.y,this._y=t.x,this._z=0,this._w=n):(this._x=0,this._y=-t.z,this._z=t.y,this._w=n)):(this._x=t.y*e.z-t.z*e.y,this._y=t.z*e.x-t.x*e.z,this._z=t.x*e.y-t.y*e.x,this._w=n),this.normalize()}angleTo(t){return 2*Math.acos(Math.abs(ye(this.dot(t),-1,1)))}rotateTowards(t,e){let n=this.angleTo(t);if(n===0)return this;let s=Math.min(1,e/n);return this.slerp(t,s),this}identity(){return this.set(0,0,0,1)}invert(){return this.conjugate()}conjugate(){return this._x*=-1,this._y*=-1,this._z*=-1,this._onChangeCallback(),this}dot(t){return this._x*t._x+this._y*t._y+this._z*t._z+this._w*t._w}lengthSq(){return this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w}length(){return Math.sqrt(this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w)}normalize(){let t=this.length();return t===0?(this._x=0,this._y=0,this._z=0,this._w=1):(t=1/t,this._x=this._x*t,this._y=this._y*t,this._z=this._z*t,this._w=this._w*t),this._onChangeCallback(),this}multiply(t){return this.multiplyQuaternions(this,t)}premultiply(t){return this.multiplyQuaternions(t,this)}multiplyQuaternions(t,e){let n=t._x,s=t._y,r=t._z,o=t._w,a=e._x,l=e._y,c=e._z,f=e._w;return this._x=n*f+o*a+s*c-r*l,this._y=s*f+o*l+r*a-n*c,this._z=r*f+o*c+n*l-s*a,this._w=o*f-n*a-s*l-r*c,this._onChangeCallback(),this}slerp(t,e){let n=t._x,s=t._y,r=t._z,o=t._w,a=this.dot(t);a<0&&(n=-n,s=-s,r=-r,o=-o,a=-a);let l=1-e;if(a<.9995){let c=Math.acos(a),f=Math.sin(c);l=Math.sin(l*c)/f,e=Math.sin(e*c)/f,this._x=this._x*l+n*e,this._y=this._y*l+s*e,this._z=this._z*l+r*e,this._w=this._w*l+o*e,this._onChangeCallback()}else this._x=this._x*l+n*e,this._y=this._y*l+s*e,this._z=this._z*l+r*e,this._w=this._w*l+o*e,this.normalize();return this}slerpQuaternions(t,e,n){return this.copy(t).slerp(e,n)}random(){let t=2*Math.PI*Math.random(),e=2*Math.PI*Math.random(),n=Math.random(),s=Math.sqrt(1-n),r=Math.sqrt(n);return this.set(s*Math.sin(t),s*Math.cos(t),r*Math.sin(e),r*Math.cos(e))}equals(t){return t._x===this._x&&t._y===this._y&&t._z===this._z&&t._w===this._w}fromArray(t,e=0){return this._x=t[e],this._y=t[e+1],this._z=t[e+2],this._w=t[e+3],this._onChangeCallback(),this}toArray(t=[],e=0){return t[e]=this._x,t[e+1]=this._y,t[e+2]=this._z,t[e+3]=this._w,t}fromBufferAttribute(t,e){return this._x=t.getX(e),this._y=t.getY(e),this._z=t.getZ(e),this._w=t.getW(e),this._onChangeCallback(),this}toJSON(){return this.toArray()}_onChange(t){return this._onChangeCallback=t,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._w}},X=class{static{this.prototype.isVector3=!0}constructor(t=0,e=0,n=0){this.x=t,this.y=e,this.z=n}set(t,e,n){return n===void 0&&(n=this.z),this.x=t,this.y=e,this.z=n,this}setScalar(t){return this.x=t,this.y=t,this.z=t,this}setX(t){return this.x=t,this}setY(t){return this.y=t,this}setZ(t){return this.z=t,this}setComponent(t,e){switch(t){case 0:this.x=e;break;case 1:this.y=e;break;case 2:this.z=e;break;default:throw new Error("THREE.Vector3: index is out of range: "+t)}return this}getComponent(t){switch(t){case 0:return this.x;case 1:return this.y;case 2:return this.z;default:throw new Error("THREE.Vector3: index is out of range: "+t)}}clone(){return new this.constructor(this.x,this.y,this.z)}copy(t){return this.x=t.x,this.y=t.y,this.z=t.z,this}add(t){return this.x+=t.x,this.y+=t.y,this.z+=t.z,this}addScalar(t){return this.x+=t,this.y+=t,this.z+=t,this}addVectors(t,e){return this.x=t.x+e.x,this.y=t.y+e.y,this.z=t.z+e.z,this}addScaledVector(t,e){return this.x+=t.x*e,this.y+=t.y*e,this.z+=t.z*e,this}sub(t){return this.x-=t.x,this.y-=t.y,this.z-=t.z,this}subScalar(t){return this.x-=t,this.y-=t,this.z-=t,this}subVectors(t,e){return this.x=t.x-e.x,this.y=t.y-e.y,this.z=t.z-e.z,this}multiply(t){return this.x*=t.x,this.y*=t.y,this.z*=t.z,this}multiplyScalar(t){return this.x*=t,this.y*=t,this.z*=t,this}multiplyVectors(t,e){return this.x=t.x*e.x,this.y=t.y*e.y,this.z=t.z*e.z,this}applyEuler(t){return this.applyQuaternion(dm.setFromEuler(t))}applyAxisAngle(t,e){return this.applyQuaternion(dm.setFromAxisAngle(t,e))}applyMatrix3(t){let e=this.x,n=this.y,s=this.z,r=t.elements;return this.x=r[0]*e+r[3]*n+r[6]*s,this.y=r[1]*e+r[4]*n+r[7]*s,this.z=r[2]*e+r[5]*n+r[8]*s,this}applyNormalMatrix(t){return this.applyMatrix3(t).normalize()}applyMatrix4(t){let e=this.x,n=this.y,s=this.z,r=t.elements,o=1/(r[3]*e+r[7]*n+r[11]*s+r[15]);return this.x=(r[0]*e+r[4]*n+r[8]*s+r[12])*o,this.y=(r[1]*e+r[5]*n+r[9]*s+r[13])*o,this.z=(r[2]*e+r[6]*n+r[10]*s+r[14])*o,this}applyQuaternion(t){let e=this.x,n=this.y,s=this.z,r=t.x,o=t.y,a=t.z,l=t.w,c=2*(o*s-a*n),f=2*(a*e-r*s),u=2*(r*n-o*e);return this.x=e+l*c+o*u-a*f,this.y=n+l*f+a*c-r*u,this.z=s+l*u+r*f-o*c,this}project(t){return this.applyMatrix4(t.matrixWorldInverse).applyMatrix4(t.projectionMatrix)}unproject(t){return this.applyMatrix4(t.projectionMatrixInverse).applyMatrix4(t.matrixWorld)}transformDirection(t){let e=this.x,n=this.y,s=this.z,r=t.elements;return this.x=r[0]*e+r[4]*n+r[8]*s,this.y=r[1]*e+r[5]*n+r[9]*s,this.z=r[2]*e+r[6]*n+r[10]*s,this.normalize()}divide(t){return this.x/=t.x,this.y/=t.y,this.z/=t.z,this}divideScalar(t){return this.multiplyScalar(1/t)}min(t){return this.x=Math.min(this.x,t.x),this.y=Math.min(this.y,t.y),this.z=Math.min(this.z,t.z),this}max(t){return this.x=Math.max(this.x,t.x),this.y=Math.max(this.y,t.y),this.z=Math.max(this.z,t.z),this}clamp(t,e){return this.x=ye(this.x,t.x,e.x),this.y=ye(this.y,t.y,e.y),this.z=ye(this.z,t.z,e.z),this}clampScalar(t,e){return this.x=ye(this.x,t,e),this.y=ye(this.y,t,e),this.z=ye(this.z,t,e),this}clampLength(t,e){let n=this.length();return this.divideScalar(n||1).multiplyScalar(ye(n,t,e))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this}dot(t){return this.x*t.x+this.y*t.y+this.z*t.z}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)}normalize(){return this.divideScalar(this.length()||1)}setLength(t){return this.normalize().multiplyScalar(t)}lerp(t,e){return this.x+=(t.x-this.x)*e,this.y+=(t.y-this.y)*e,this.z+=(t.z-this.z)*e,this}lerpVectors(t,e,n){return this.x=t.x+(e.x-t.x)*n,this.y=t.y+(e.y-t.y)*n,this.z=t.z+(e.z-t.z)*n,this}cross(t){return this.crossVectors(this,t)}crossVectors(t,e){let n=t.x,s=t.y,r=t.z,o=e.x,a=e.y,l=e.z;return this.x=s*l-r*a,this.y=r*o-n*l,this.z=n*a-s*o,this}projectOnVector(t){let e=t.lengthSq();if(e===0)return this.set(0,0,0);let n=t.dot(this)/e;return this.copy(t).multiplyScalar(n)}projectOnPlane(t){return Pu.copy(this).projectOnVector(t),this.sub(Pu)}reflect(t){return this.sub(Pu.copy(t).multiplyScalar(2*this.dot(t)))}angleTo(t){let e=Math.sqrt(this.lengthSq()*t.lengthSq());if(e===0)return Math.PI/2;let n=this.dot(t)/e;return Math.acos(ye(n,-1,1))}distanceTo(t){return Math.sqrt(this.distanceToSquared(t))}distanceToSquared(t){let e=this.x-t.x,n=this.y-t.y,s=this.z-t.z;return e*e+n*n+s*s}manhattanDistanceTo(t){return Math.abs(this.x-t.x)+Math.abs(this.y-t.y)+Math.abs(this.z-t.z)}setFromSpherical(t){return this.setFromSphericalCoords(t.radius,t.phi,t.theta)}setFromSphericalCoords(t,e,n){let s=Math.sin(e)*t;return this.x=s*Math.sin(n),this.y=Math.cos(e)*t,this.z=s*Math.cos(n),this}setFromCylindrical(t){return this.setFromCylindricalCoords(t.radius,t.theta,t.y)}setFromCylindricalCoords(t,e,n){return this.x=t*Math.sin(e),this.y=n,this.z=t*Math.cos(e),this}setFromMatrixPosition(t){let e=t.elements;return this.x=e[12],this.y=e[13],this.z=e[14],this}setFromMatrixScale(t){let e=this.setFromMatrixColumn(t,0).length(),n=this.setFromMatrixColumn(t,1).length(),s=this.setFromMatrixColumn(t,2).length();return this.x=e,this.y=n,this.z=s,this}setFromMatrixColumn(t,e){return this.fromArray(t.elements,e*4)}setFromMatrix3Column(t,e){return this.fromArray(t.elements,e*3)}setFromEuler(t){return this.x=t._x,this.y=t._y,this.z=t._z,this}setFromColor(t){return this.x=t.r,this.y=t.g,this.z=t.b,this}equals(t){return t.x===this.x&&t.y===this.y&&t.z===this.z}fromArray(t,e=0){return this.x=t[e],this.y=t[e+1],this.z=t[e+2],this}toArray(t=[],e=0){return t[e]=this.x,t[e+1]=this.y,t[e+2]=this.z,t}fromBufferAttribute(t,e){return this.x=t.getX(e),this.y=t.getY(e),this.z=t.getZ(e),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this}randomDirection(){let t=Math.random()*Math.PI*2,e=Math.random()*2-1,n=Math.sqrt(1-e*e);return this.x=n*Math.cos(t),this.y=e,this.z=n*Math.sin(t),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z}},Pu=new X,dm=new Qn,oe=class{static{this.prototype.isMatrix3=!0}constructor(t,e,n,s,r,o,a,l,c){this.elements=[1,0,0,0,1,0,0,0,1],t!==void 0&&this.set(t,e,n,s,r,o,a,l,c)}set(t,e,n,s,r,o,a,l,c){let f=this.elements;return f[0]=t,f[1]=s,f[2]=a,f[3]=e,f[4]=r,f[5]=l,f[6]=n,f[7]=o,f[8]=c,this}identity(){return this.set(1,0,0,0,1,0,0,0,1),this}copy(t){let e=this.elements,n=t.elements;return e[0]=n[0],e[1]=n[1],e[2]=n[2],e[3]=n[3],e[4]=n[4],e[5]=n[5],e[6]=n[6],e[7]=n[7],e[8]=n[8],this}extractBasis(t,e,n){return t.setFromMatrix3Column(this,0),e.setFromMatrix3Column(this,1),n.setFromMatrix3Column(this,2),this}setFromMatrix4(t){let e=t.elements;return this.set(e[0],e[4],e[8],e[1],e[5],e[9],e[2],e[6],e[10]),this}multiply(t){return this.multiplyMatrices(this,t)}premultiply(t){return this.multiplyMatrices(t,this)}multiplyMatrices(t,e){let n=t.elements,s=e.elements,r=this.elements,o=n[0],a=n[3],l=n[6],c=n[1],f=n[4],u=n[7],h=n[2],d=n[5],p=n[8],_=s[0],g=s[3],m=s[6],v=s[1],A=s[4],S=s[7],R=s[2],E=s[5],x=s[8];return r[0]=o*_+a*v+l*R,r[3]=o*g+a*A+l*E,r[6]=o*m+a*S+l*x,r[1]=c*_+f*v+u*R,r[4]=c*g+f*A+u*E,r[7]=c*m+f*S+u*x,r[2]=h*_+d*v+p*R,r[5]=h*g+d*A+p*E,r[8]=h*m+d*S+p*x,this}multiplyScalar(t){let e=this.elements;return e[0]*=t,e[3]*=t,e[6]*=t,e[1]*=t,e[4]*=t,e[7]*=t,e[2]*=t,e[5]*=t,e[8]*=t,this}determinant(){let t=this.elements,e=t[0],n=t[1],s=t[2],r=t[3],o=t[4],a=t[5],l=t[6],c=t[7],f=t[8];return e*o*f-e*a*c-n*r*f+n*a*l+s*r*c-s*o*l}invert(){let t=this.elements,e=t[0],n=t[1],s=t[2],r=t[3],o=t[4],a=t[5],l=t[6],c=t[7],f=t[8],u=f*o-a*c,h=a*l-f*r,d=c*r-o*l,p=e*u+n*h+s*d;if(p===0)return this.set(0,0,0,0,0,0,0,0,0);let _=1/p;return t[0]=u*_,t[1]=(s*c-f*n)*_,t[2]=(a*n-s*o)*_,t[3]=h*_,t[4]=(f*e-s*l)*_,t[5]=(s*r-a*e)*_,t[6]=d*_,t[7]=(n*l-c*e)*_,t[8]=(o*e-n*r)*_,this}transpose(){let t,e=this.elements;return t=e[1],e[1]=e[3],e[3]=t,t=e[2],e[2]=e[6],e[6]=t,t=e[5],e[5]=e[7],e[7]=t,this}getNormalMatrix(t){return this.setFromMatrix4(t).invert().transpose()}transposeIntoArray(t){let e=this.elements;return t[0]=e[0],t[1]=e[3],t[2]=e[6],t[3]=e[1],t[4]=e[4],t[5]=e[7],t[6]=e[2],t[7]=e[5],t[8]=e[8],this}setUvTransform(t,e,n,s,r,o,a){let l=Math.cos(r),c=Math.sin(r);return this.set(n*l,n*c,-n*(l*o+c*a)+o+t,-s*c,s*l,-s*(-c*o+l*a)+a+e,0,0,1),this}scale(t,e){return aa("Matrix3: .scale() is deprecated. Use .makeScale() instead."),this.premultiply(Iu.makeScale(t,e)),this}rotate(t){return aa("Matrix3: .rotate() is deprecated. Use .makeRotation() instead."),this.premultiply(Iu.makeRotation(-t)),this}translate(t,e){return aa("Matrix3: .translate() is deprecated. Use .makeTranslation() instead."),this.premultiply(Iu.makeTranslation(t,e)),this}makeTranslation(t,e){return t.isVector2?this.set(1,0,t.x,0,1,t.y,0,0,1):this.set(1,0,t,0,1,e,0,0,1),this}makeRotation(t){let e=Math.cos(t),n=Math.sin(t);return this.set(e,-n,0,n,e,0,0,0,1),this}makeScale(t,e){return this.set(t,0,0,0,e,0,0,0,1),this}equals(t){let e=this.elements,n=t.elements;for(let s=0;s<9;s++)if(e[s]!==n[s])return!1;return!0}fromArray(t,e=0){for(let n=0;n<9;n++)this.elements[n]=t[n+e];return this}toArray(t=[],e=0){let n=this.elements;return t[e]=n[0],t[e+1]=n[1],t[e+2]=n[2],t[e+3]=n[3],t[e+4]=n[4],t[e+5]=n[5],t[e+6]=n[6],t[e+7]=n[7],t[e+8]=n[8],t}clone(){return new this.constructor().fromArray(this.elements)}},Iu=new oe,pm=new oe().set(.4123908,.3575843,.1804808,.212639,.7151687,.0721923,.0193308,.1191948,.9505322),mm=new oe().set(3.2409699,-1.5373832,-.4986108,-.9692436,1.8759675,.0415551,.0556301,-.203977,1.0569715);function vv(){let i={enabled:!0,workingColorSpace:ha,spaces:{},convert:function(s,r,o){return this.enabled===!1||r===o||!r||!o||(this.spaces[r].transfer===Le&&(s.r=Ms(s.r),s.g=Ms(s.g),s.b=Ms(s.b)),this.spaces[r].primaries!==this.spaces[o].primaries&&(s.applyMatrix3(this.spaces[r].toXYZ),s.applyMatrix3(this.spaces[o].fromXYZ)),this.spaces[o].transfer===Le&&(s.r=ho(s.r),s.g=ho(s.g),s.b=ho(s.b))),s},workingToColorSpace:function(s,r){return this.convert(s,this.workingColorSpace,r)},colorSpaceToWorking:function(s,r){return this.convert(s,r,this.workingColorSpace)},getPrimaries:function(s){return this.spaces[s].primaries},getTransfer:function(s){return s===Cs?ua:this.spaces[s].transfer},getToneMappingMode:function(s){return this.spaces[s].outputColorSpaceConfig.toneMappingMode||"standard"},getLuminanceCoefficients:function(s,r=this.workingColorSpace){return s.fromArray(this.spaces[r].luminanceCoefficients)},define:function(s){Object.assign(this.spaces,s)},_getMatrix:function(s,r,o){return s.copy(this.spaces[o].fromXYZ).multiply(this.spaces[r].toXYZ)},_getDrawingBufferColorSpace:function(s){return this.spaces[s].outputColorSpaceConfig.drawingBufferColorSpace},_getUnpackColorSpace:function(s=this.workingColorSpace){return this.spaces[s].workingColorSpaceConfig.unpackColorSpace}},t=[.64,.33,.3,.6,.15,.06],e=[.2126,.7152,.0722],n=[.3127,.329];return i.define({[ha]:{primaries:t,whitePoint:n,transfer:ua,toXYZ:pm,fromXYZ:mm,luminanceCoefficients:e,workingColorSpaceConfig:{unpackColorSpace:Jn},outputColorSpaceConfig:{drawingBufferColorSpace:Jn}},[Jn]:{primaries:t,whitePoint:n,transfer:Le,toXYZ:pm,fromXYZ:mm,luminanceCoefficients:e,outputColorSpaceConfig:{drawingBufferColorSpace:Jn}}}),i}var Me=vv();function Ms(i){return i<.04045?i*.0773993808:Math.pow(i*.9478672986+.0521327014,2.4)}function ho(i){return i<.0031308?i*12.92:1.055*Math.pow(i,.41666)-.055}var qr,Mc=class{static getDataURL(t,e="image/png"){if(/^data:/i.test(t.src)||typeof HTMLCanvasElement>"u")return t.src;let n;if(t instanceof HTMLCanvasElement)n=t;else{qr===void 0&&(qr=fa("canvas")),qr.width=t.width,qr.height=t.height;let s=qr.getContext("2d");t instanceof ImageData?s.putImageData(t,0,0):s.drawImage(t,0,0,t.width,t.height),n=qr}return n.toDataURL(e)}static sRGBToLinear(t){if(typeof HTMLImageElement<"u"&&t instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&t instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&t instanceof ImageBitmap){let e=fa("canvas");e.width=t.width,e.height=t.height;let n=e.getContext("2d");n.drawImage(t,0,0,t.width,t.height);let s=n.getImageData(0,0,t.width,t.height),r=s.data;for(let o=0;o<r.length;o++)r[o]=Ms(r[o]/255)*255;return n.putImageData(s,0,0),e}else if(t.data){let e=t.data.slice(0);for(let n=0;n<e.length;n++)e instanceof Uint8Array||e instanceof Uint8ClampedArray?e[n]=Math.floor(Ms(e[n]/255)*255):e[n]=Ms(e[n]);return{data:e,width:t.width,height:t.height}}else return jt("ImageUtils.sRGBToLinear(): Unsupported image type. No color space conversion applied."),t}},Sv=0,go=class{constructor(t=null){this.isTextureSource=!0,Object.defineProperty(this,"id",{value:Sv++}),this.uuid=tr(),this.data=t,this.dataReady=!0,this.version=0}getSize(t){let e=this.data;return typeof HTMLVideoElement<"u"&&e instanceof HTMLVideoElement?t.set(e.videoWidth,e.videoHeight,0):typeof VideoFrame<"u"&&e instanceof VideoFrame?t.set(e.displayWidth,e.displayHeight,0):e!==null?t.set(e.width||0,e.height||0,e.depth||0):t.set(0,0,0),t}set needsUpdate(t){t===!0&&this.version++}toJSON(t){let e=t===void 0||typeof t=="string";if(!e&&t.images[this.uuid]!==void 0)return t.images[this.uuid];let n={uuid:this.uuid,url:""},s=this.data;if(s!==null){let r;if(Array.isArray(s)){r=[];for(let o=0,a=s.length;o<a;o++)s[o].isDataTexture?r.push(Lu(s[o].image)):r.push(Lu(s[o]))}else r=Lu(s);n.url=r}return e||(t.images[this.uuid]=n),n}};function Lu(i){return typeof HTMLImageElement<"u"&&i instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&i instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&i instanceof ImageBitmap?Mc.getDataURL(i):i.data?{data:Array.from(i.data),width:i.width,height:i.height,type:i.data.constructor.name}:(jt("Texture: Unable to serialize Texture."),{})}var Mv=0,Du=new X,ti=class i extends Oi{constructor(t=i.DEFAULT_IMAGE,e=i.DEFAULT_MAPPING,n=es,s=es,r=jn,o=Es,a=Vi,l=ai,c=i.DEFAULT_ANISOTROPY,f=Cs){super(),this.isTexture=!0,Object.defineProperty(this,"id",{value:Mv++}),this.uuid=tr(),this.name="",this.source=new go(t),this.mipmaps=[],this.mapping=e,this.channel=0,this.wrapS=n,this.wrapT=s,this.magFilter=r,this.minFilter=o,this.anisotropy=c,this.format=a,this.internalFormat=null,this.type=l,this.offset=new Jt(0,0),this.repeat=new Jt(1,1),this.center=new Jt(0,0),this.rotation=0,this.matrixAutoUpdate=!0,this.matrix=new oe,this.generateMipmaps=!0,this.mipmapsAutoUpdate=!0,this.premultiplyAlpha=!1,this.flipY=!0,this.unpackAlignment=4,this.colorSpace=f,this.userData={},this.updateRanges=[],this.version=0,this.onUpdate=null,this.renderTarget=null,this.isRenderTargetTexture=!1,this.isArrayTexture=!!(t&&t.depth&&t.depth>1),this.pmremVersion=0,this.isPMREMTexture=!1,this.normalized=!1}get width(){return this.source.getSize(Du).x}get height(){return this.source.getSize(Du).y}get depth(){return this.source.getSize(Du).z}get image(){return this.source.data}set image(t){this.source.data=t}updateMatrix(){this.matrix.setUvTransform(this.offset.x,this.offset.y,this.repeat.x,this.repeat.y,this.rotation,this.center.x,this.center.y)}addUpdateRange(t,e){this.updateRanges.push({start:t,count:e})}clearUpdateRanges(){this.updateRanges.length=0}clone(){return new this.constructor().copy(this)}copy(t){return this.name=t.name,this.source=t.source,this.mipmaps=t.mipmaps.slice(0),this.mapping=t.mapping,this.channel=t.channel,this.wrapS=t.wrapS,this.wrapT=t.wrapT,this.magFilter=t.magFilter,this.minFilter=t.minFilter,this.anisotropy=t.anisotropy,this.format=t.format,this.internalFormat=t.internalFormat,this.type=t.type,this.normalized=t.normalized,this.offset.copy(t.offset),this.repeat.copy(t.repeat),this.center.copy(t.center),this.rotation=t.rotation,this.matrixAutoUpdate=t.matrixAutoUpdate,this.matrix.copy(t.matrix),this.generateMipmaps=t.generateMipmaps,this.mipmapsAutoUpdate=t.mipmapsAutoUpdate,this.premultiplyAlpha=t.premultiplyAlpha,this.flipY=t.flipY,this.unpackAlignment=t.unpackAlignment,this.colorSpace=t.colorSpace,this.renderTarget=t.renderTarget,this.isRenderTargetTexture=t.isRenderTargetTexture,this.isPMREMTexture=t.isPMREMTexture,this.isArrayTexture=t.isArrayTexture,this.userData=JSON.parse(JSON.stringify(t.userData)),this.needsUpdate=!0,this}setValues(t){for(let e in t){let n=t[e];if(n===void 0){jt(`Texture.setValues(): parameter '${e}' has value of undefined.`);continue}let s=this[e];if(s===void 0){jt(`Texture.setValues(): property '${e}' does not exist.`);continue}s&&n&&s.isVector2&&n.isVector2||s&&n&&s.isVector3&&n.isVector3||s&&n&&s.isMatrix3&&n.isMatrix3?s.copy(n):this[e]=n}}toJSON(t){let e=t===void 0||typeof t=="string";if(!e&&t.textures[this.uuid]!==void 0)return t.textures[this.uuid];let n={metadata:{version:4.7,type:"Texture",generator:"Texture.toJSON"},uuid:this.uuid,name:this.name,image:this.source.toJSON(t).uuid,mapping:this.mapping,channel:this.channel,repeat:[this.repeat.x,this.repeat.y],offset:[this.offset.x,this.offset.y],center:[this.center.x,this.center.y],rotation:this.rotation,wrap:[this.wrapS,this.wrapT],format:this.format,internalFormat:this.internalFormat,type:this.type,normalized:this.normalized,colorSpace:this.colorSpace,minFilter:this.minFilter,magFilter:this.magFilter,anisotropy:this.anisotropy,flipY:this.flipY,generateMipmaps:this.generateMipmaps,mipmapsAutoUpdate:this.mipmapsAutoUpdate,premultiplyAlpha:this.premultiplyAlpha,unpackAlignment:this.unpackAlignment};return Object.keys(this.userData).length>0&&(n.userData=this.userData),e||(t.textures[this.uuid]=n),n}dispose(){this.dispatchEvent({type:"dispose"})}transformUv(t){if(this.mapping!==Sf)return t;if(t.applyMatrix3(this.matrix),t.x<0||t.x>1)switch(this.wrapS){case yc:t.x=t.x-Math.floor(t.x);break;case es:t.x=t.x<0?0:1;break;case vc:Math.abs(Math.floor(t.x)%2)===1?t.x=Math.ceil(t.x)-t.x:t.x=t.x-Math.floor(t.x);break}if(t.y<0||t.y>1)switch(this.wrapT){case yc:t.y=t.y-Math.floor(t.y);break;case es:t.y=t.y<0?0:1;break;case vc:Math.abs(Math.floor(t.y)%2)===1?t.y=Math.ceil(t.y)-t.y:t.y=t.y-Math.floor(t.y);break}return this.flipY&&(t.y=1-t.y),t}set needsUpdate(t){t===!0&&(this.version++,this.source.needsUpdate=!0)}set needsPMREMUpdate(t){t===!0&&this.pmremVersion++}};ti.DEFAULT_IMAGE=null;ti.DEFAULT_MAPPING=Sf;ti.DEFAULT_ANISOTROPY=1;var Qe=class{static{this.prototype.isVector4=!0}constructor(t=0,e=0,n=0,s=1){this.x=t,this.y=e,this.z=n,this.w=s}get width(){return this.z}set width(t){this.z=t}get height(){return this.w}set height(t){this.w=t}set(t,e,n,s){return this.x=t,this.y=e,this.z=n,this.w=s,this}setScalar(t){return this.x=t,this.y=t,this.z=t,this.w=t,this}setX(t){return this.x=t,this}setY(t){return this.y=t,this}setZ(t){return this.z=t,this}setW(t){return this.w=t,this}setComponent(t,e){switch(t){case 0:this.x=e;break;case 1:this.y=e;break;case 2:this.z=e;break;case 3:this.w=e;break;default:throw new Error("THREE.Vector4: index is out of range: "+t)}return this}getComponent(t){switch(t){case 0:return this.x;case 1:return this.y;case 2:return this.z;case 3:return this.w;default:throw new Error("THREE.Vector4: index is out of range: "+t)}}clone(){return new this.constructor(this.x,this.y,this.z,this.w)}copy(t){return this.x=t.x,this.y=t.y,this.z=t.z,this.w=t.w!==void 0?t.w:1,this}add(t){return this.x+=t.x,this.y+=t.y,this.z+=t.z,this.w+=t.w,this}addScalar(t){return this.x+=t,this.y+=t,this.z+=t,this.w+=t,this}addVectors(t,e){return this.x=t.x+e.x,this.y=t.y+e.y,this.z=t.z+e.z,this.w=t.w+e.w,this}addScaledVector(t,e){return this.x+=t.x*e,this.y+=t.y*e,this.z+=t.z*e,this.w+=t.w*e,this}sub(t){return this.x-=t.x,this.y-=t.y,this.z-=t.z,this.w-=t.w,this}subScalar(t){return this.x-=t,this.y-=t,this.z-=t,this.w-=t,this}subVectors(t,e){return this.x=t.x-e.x,this.y=t.y-e.y,this.z=t.z-e.z,this.w=t.w-e.w,this}multiply(t){return this.x*=t.x,this.y*=t.y,this.z*=t.z,this.w*=t.w,this}multiplyScalar(t){return this.x*=t,this.y*=t,this.z*=t,this.w*=t,this}applyMatrix4(t){let e=this.x,n=this.y,s=this.z,r=this.w,o=t.elements;return this.x=o[0]*e+o[4]*n+o[8]*s+o[12]*r,this.y=o[1]*e+o[5]*n+o[9]*s+o[13]*r,this.z=o[2]*e+o[6]*n+o[10]*s+o[14]*r,this.w=o[3]*e+o[7]*n+o[11]*s+o[15]*r,this}divide(t){return this.x/=t.x,this.y/=t.y,this.z/=t.z,this.w/=t.w,this}divideScalar(t){return this.multiplyScalar(1/t)}setAxisAngleFromQuaternion(t){this.w=2*Math.acos(t.w);let e=Math.sqrt(1-t.w*t.w);return e<1e-4?(this.x=1,this.y=0,this.z=0):(this.x=t.x/e,this.y=t.y/e,this.z=t.z/e),this}setAxisAngleFromRotationMatrix(t){let e,n,s,r,l=t.elements,c=l[0],f=l[4],u=l[8],h=l[1],d=l[5],p=l[9],_=l[2],g=l[6],m=l[10];if(Math.abs(f-h)<.01&&Math.abs(u-_)<.01&&Math.abs(p-g)<.01){if(Math.abs(f+h)<.1&&Math.abs(u+_)<.1&&Math.abs(p+g)<.1&&Math.abs(c+d+m-3)<.1)return this.set(1,0,0,0),this;e=Math.PI;let A=(c+1)/2,S=(d+1)/2,R=(m+1)/2,E=(f+h)/4,x=(u+_)/4,T=(p+g)/4;return A>S&&A>R?A<.01?(n=0,s=.707106781,r=.707106781):(n=Math.sqrt(A),s=E/n,r=x/n):S>R?S<.01?(n=.707106781,s=0,r=.707106781):(s=Math.sqrt(S),n=E/s,r=T/s):R<.01?(n=.707106781,s=.707106781,r=0):(r=Math.sqrt(R),n=x/r,s=T/r),this.set(n,s,r,e),this}let v=Math.sqrt((g-p)*(g-p)+(u-_)*(u-_)+(h-f)*(h-f));return Math.abs(v)<.001&&(v=1),this.x=(g-p)/v,this.y=(u-_)/v,this.z=(h-f)/v,this.w=Math.acos((c+d+m-1)/2),this}setFromMatrixPosition(t){let e=t.elements;return this.x=e[12],this.y=e[13],this.z=e[14],this.w=e[15],this}min(t){return this.x=Math.min(this.x,t.x),this.y=Math.min(this.y,t.y),this.z=Math.min(this.z,t.z),this.w=Math.min(this.w,t.w),this}max(t){return this.x=Math.max(this.x,t.x),this.y=Math.max(this.y,t.y),this.z=Math.max(this.z,t.z),this.w=Math.max(this.w,t.w),this}clamp(t,e){return this.x=ye(this.x,t.x,e.x),this.y=ye(this.y,t.y,e.y),this.z=ye(this.z,t.z,e.z),this.w=ye(this.w,t.w,e.w),this}clampScalar(t,e){return this.x=ye(this.x,t,e),this.y=ye(this.y,t,e),this.z=ye(this.z,t,e),this.w=ye(this.w,t,e),this}clampLength(t,e){let n=this.length();return this.divideScalar(n||1).multiplyScalar(ye(n,t,e))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this.w=Math.floor(this.w),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this.w=Math.ceil(this.w),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this.w=Math.round(this.w),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this.w=Math.trunc(this.w),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this.w=-this.w,this}dot(t){return this.x*t.x+this.y*t.y+this.z*t.z+this.w*t.w}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)+Math.abs(this.w)}normalize(){return this.divideScalar(this.length()||1)}setLength(t){return this.normalize().multiplyScalar(t)}lerp(t,e){return this.x+=(t.x-this.x)*e,this.y+=(t.y-this.y)*e,this.z+=(t.z-this.z)*e,this.w+=(t.w-this.w)*e,this}lerpVectors(t,e,n){return this.x=t.x+(e.x-t.x)*n,this.y=t.y+(e.y-t.y)*n,this.z=t.z+(e.z-t.z)*n,this.w=t.w+(e.w-t.w)*n,this}equals(t){return t.x===this.x&&t.y===this.y&&t.z===this.z&&t.w===this.w}fromArray(t,e=0){return this.x=t[e],this.y=t[e+1],this.z=t[e+2],this.w=t[e+3],this}toArray(t=[],e=0){return t[e]=this.x,t[e+1]=this.y,t[e+2]=this.z,t[e+3]=this.w,t}fromBufferAttribute(t,e){return this.x=t.getX(e),this.y=t.getY(e),this.z=t.getZ(e),this.w=t.getW(e),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this.w=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z,yield this.w}},bc=class extends Oi{constructor(t=1,e=1,n={}){super(),n=Object.assign({generateMipmaps:!1,internalFormat:null,minFilter:jn,depthBuffer:!0,stencilBuffer:!1,resolveColorBuffer:!0,resolveDepthBuffer:!0,resolveStencilBuffer:!0,storeMultisampledColorBuffer:!0,storeMultisampledDepthBuffer:!0,storeMultisampledStencilBuffer:!0,depthTexture:null,samples:0,count:1,depth:1,multiview:!1,useArrayDepthTexture:!1},n),this.isRenderTarget=!0,this.width=t,this.height=e,this.depth=n.depth,this.scissor=new Qe(0,0,t,e),this.scissorTest=!1,this.viewport=new Qe(0,0,t,e),this.textures=[];let s=n.count;for(let r=0;r<s;r++)this.textures[r]=new ti({width:t,height:e,depth:n.depth}),this.textures[r].isRenderTargetTexture=!0,this.textures[r].renderTarget=this;this._setTextureOptions(n),this.depthBuffer=n.depthBuffer,this.stencilBuffer=n.stencilBuffer,this.resolveColorBuffer=n.resolveColorBuffer,this.resolveDepthBuffer=n.resolveDepthBuffer,this.resolveStencilBuffer=n.resolveStencilBuffer,this.storeMultisampledColorBuffer=n.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=n.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=n.storeMultisampledStencilBuffer,this._depthTexture=null,this.depthTexture=n.depthTexture,this.samples=n.samples,this.multiview=n.multiview,this.useArrayDepthTexture=n.useArrayDepthTexture}_setTextureOptions(t={}){let e={minFilter:jn,generateMipmaps:!1,flipY:!1,internalFormat:null};t.mapping!==void 0&&(e.mapping=t.mapping),t.wrapS!==void 0&&(e.wrapS=t.wrapS),t.wrapT!==void 0&&(e.wrapT=t.wrapT),t.wrapR!==void 0&&(e.wrapR=t.wrapR),t.magFilter!==void 0&&(e.magFilter=t.magFilter),t.minFilter!==void 0&&(e.minFilter=t.minFilter),t.format!==void 0&&(e.format=t.format),t.type!==void 0&&(e.type=t.type),t.anisotropy!==void 0&&(e.anisotropy=t.anisotropy),t.colorSpace!==void 0&&(e.colorSpace=t.colorSpace),t.flipY!==void 0&&(e.flipY=t.flipY),t.generateMipmaps!==void 0&&(e.generateMipmaps=t.generateMipmaps),t.mipmapsAutoUpdate!==void 0&&(e.mipmapsAutoUpdate=t.mipmapsAutoUpdate),t.internalFormat!==void 0&&(e.internalFormat=t.internalFormat);for(let n=0;n<this.textures.length;n++)this.textures[n].setValues(e)}get texture(){return this.textures[0]}set texture(t){this.textures[0]=t}set depthTexture(t){this._depthTexture!==null&&this._depthTexture.renderTarget===this&&(this._depthTexture.renderTarget=null),t!==null&&t.renderTarget===null&&(t.renderTarget=this),this._depthTexture=t}get depthTexture(){return this._depthTexture}setSize(t,e,n=1){if(this.width!==t||this.height!==e||this.depth!==n){this.width=t,this.height=e,this.depth=n;for(let s=0,r=this.textures.length;s<r;s++)this.textures[s].image.width=t,this.textures[s].image.height=e,this.textures[s].image.depth=n,this.textures[s].isData3DTexture!==!0&&(this.textures[s].isArrayTexture=this.textures[s].image.depth>1);this.dispose()}this.viewport.set(0,0,t,e),this.scissor.set(0,0,t,e)}clone(){return new this.constructor().copy(this)}copy(t){this.width=t.width,this.height=t.height,this.depth=t.depth,this.scissor.copy(t.scissor),this.scissorTest=t.scissorTest,this.viewport.copy(t.viewport),this.textures.length=0;for(let e=0,n=t.textures.length;e<n;e++){this.textures[e]=t.textures[e].clone(),this.textures[e].isRenderTargetTexture=!0,this.textures[e].renderTarget=this;let s=Object.assign({},t.textures[e].image);this.textures[e].source=new go(s)}if(this.depthBuffer=t.depthBuffer,this.stencilBuffer=t.stencilBuffer,this.resolveColorBuffer=t.resolveColorBuffer,this.resolveDepthBuffer=t.resolveDepthBuffer,this.resolveStencilBuffer=t.resolveStencilBuffer,this.storeMultisampledColorBuffer=t.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=t.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=t.storeMultisampledStencilBuffer,t.depthTexture!==null)if(t.depthTexture.renderTarget===t){let e=t.depthTexture.clone();e.renderTarget=null,this.depthTexture=e}else this.depthTexture=t.depthTexture;else this.depthTexture=null;return this.samples=t.samples,this.multiview=t.multiview,this.useArrayDepthTexture=t.useArrayDepthTexture,this}dispose(){this.dispatchEvent({type:"dispose"})}},gi=class extends bc{constructor(t=1,e=1,n={}){super(t,e,n),this.isWebGLRenderTarget=!0}},pa=class extends ti{constructor(t=null,e=1,n=1,s=1){super(null),this.isDataArrayTexture=!0,this.image={data:t,width:e,height:n,depth:s},this.magFilter=Un,this.minFilter=Un,this.wrapR=es,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1,this.layerUpdates=new Set}copy(t){return super.copy(t),this.wrapR=t.wrapR,this}addLayerUpdate(t){this.layerUpdates.add(t)}clearLayerUpdates(){this.layerUpdates.clear()}};var wc=class extends ti{constructor(t=null,e=1,n=1,s=1){super(null),this.isData3DTexture=!0,this.image={data:t,width:e,height:n,depth:s},this.magFilter=Un,this.minFilter=Un,this.wrapR=es,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}copy(t){return super.copy(t),this.wrapR=t.wrapR,this}};var De=class i{static{this.prototype.isMatrix4=!0}constructor(t,e,n,s,r,o,a,l,c,f,u,h,d,p,_,g){this.elements=[1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1],t!==void 0&&this.set(t,e,n,s,r,o,a,l,c,f,u,h,d,p,_,g)}set(t,e,n,s,r,o,a,l,c,f,u,h,d,p,_,g){let m=this.elements;return m[0]=t,m[4]=e,m[8]=n,m[12]=s,m[1]=r,m[5]=o,m[9]=a,m[13]=l,m[2]=c,m[6]=f,m[10]=u,m[14]=h,m[3]=d,m[7]=p,m[11]=_,m[15]=g,this}identity(){return this.set(1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1),this}clone(){return new i().fromArray(this.elements)}copy(t){let e=this.elements,n=t.elements;return e[0]=n[0],e[1]=n[1],e[2]=n[2],e[3]=n[3],e[4]=n[4],e[5]=n[5],e[6]=n[6],e[7]=n[7],e[8]=n[8],e[9]=n[9],e[10]=n[10],e[11]=n[11],e[12]=n[12],e[13]=n[13],e[14]=n[14],e[15]=n[15],this}copyPosition(t){let e=this.elements,n=t.elements;return e[12]=n[12],e[13]=n[13],e[14]=n[14],this}setFromMatrix3(t){let e=t.elements;return this.set(e[0],e[3],e[6],0,e[1],e[4],e[7],0,e[2],e[5],e[8],0,0,0,0,1),this}extractBasis(t,e,n){return this.determinantAffine()===0?(t.set(1,0,0),e.set(0,1,0),n.set(0,0,1),this):(t.setFromMatrixColumn(this,0),e.setFromMatrixColumn(this,1),n.setFromMatrixColumn(this,2),this)}makeBasis(t,e,n){return this.set(t.x,e.x,n.x,0,t.y,e.y,n.y,0,t.z,e.z,n.z,0,0,0,0,1),this}extractRotation(t){if(t.determinantAffine()===0)return this.identity();let e=this.elements,n=t.elements,s=1/$r.setFromMatrixColumn(t,0).length(),r=1/$r.setFromMatrixColumn(t,1).length(),o=1/$r.setFromMatrixColumn(t,2).length();return e[0]=n[0]*s,e[1]=n[1]*s,e[2]=n[2]*s,e[3]=0,e[4]=n[4]*r,e[5]=n[5]*r,e[6]=n[6]*r,e[7]=0,e[8]=n[8]*o,e[9]=n[9]*o,e[10]=n[10]*o,e[11]=0,e[12]=0,e[13]=0,e[14]=0,e[15]=1,this}makeRotationFromEuler(t){let e=this.elements,n=t.x,s=t.y,r=t.z,o=Math.cos(n),a=Math.sin(n),l=Math.cos(s),c=Math.sin(s),f=Math.cos(r),u=Math.sin(r);if(t.order==="XYZ"){let h=o*f,d=o*u,p=a*f,_=a*u;e[0]=l*f,e[4]=-l*u,e[8]=c,e[1]=d+p*c,e[5]=h-_*c,e[9]=-a*l,e[2]=_-h*c,e[6]=p+d*c,e[10]=o*l}else if(t.order==="YXZ"){let h=l*f,d=l*u,p=c*f,_=c*u;e[0]=h+_*a,e[4]=p*a-d,e[8]=o*c,e[1]=o*u,e[5]=o*f,e[9]=-a,e[2]=d*a-p,e[6]=_+h*a,e[10]=o*l}else if(t.order==="ZXY"){let h=l*f,d=l*u,p=c*f,_=c*u;e[0]=h-_*a,e[4]=-o*u,e[8]=p+d*a,e[1]=d+p*a,e[5]=o*f,e[9]=_-h*a,e[2]=-o*c,e[6]=a,e[10]=o*l}else if(t.order==="ZYX"){let h=o*f,d=o*u,p=a*f,_=a*u;e[0]=l*f,e[4]=p*c-d,e[8]=h*c+_,e[1]=l*u,e[5]=_*c+h,e[9]=d*c-p,e[2]=-c,e[6]=a*l,e[10]=o*l}else if(t.order==="YZX"){let h=o*l,d=o*c,p=a*l,_=a*c;e[0]=l*f,e[4]=_-h*u,e[8]=p*u+d,e[1]=u,e[5]=o*f,e[9]=-a*f,e[2]=-c*f,e[6]=d*u+p,e[10]=h-_*u}else if(t.order==="XZY"){let h=o*l,d=o*c,p=a*l,_=a*c;e[0]=l*f,e[4]=-u,e[8]=c*f,e[1]=h*u+_,e[5]=o*f,e[9]=d*u-p,e[2]=p*u-d,e[6]=a*f,e[10]=_*u+h}return e[3]=0,e[7]=0,e[11]=0,e[12]=0,e[13]=0,e[14]=0,e[15]=1,this}makeRotationFromQuaternion(t){return this.compose(bv,t,wv)}lookAt(t,e,n){let s=this.elements;return di.subVectors(t,e),di.lengthSq()===0&&(di.z=1),di.normalize(),zs.crossVectors(n,di),zs.lengthSq()===0&&(Math.abs(n.z)===1?di.x+=1e-4:di.z+=1e-4,di.normalize(),zs.crossVectors(n,di)),zs.normalize(),Fl.crossVectors(di,zs),s[0]=zs.x,s[4]=Fl.x,s[8]=di.x,s[1]=zs.y,s[5]=Fl.y,s[9]=di.y,s[2]=zs.z,s[6]=Fl.z,s[10]=di.z,this}multiply(t){return this.multiplyMatrices(this,t)}premultiply(t){return this.multiplyMatrices(t,this)}multiplyMatrices(t,e){let n=t.elements,s=e.elements,r=this.elements,o=n[0],a=n[4],l=n[8],c=n[12],f=n[1],u=n[5],h=n[9],d=n[13],p=n[2],_=n[6],g=n[10],m=n[14],v=n[3],A=n[7],S=n[11],R=n[15],E=s[0],x=s[4],T=s[8],U=s[12],N=s[1],L=s[5],z=s[9],O=s[13],P=s[2],G=s[6],q=s[10],H=s[14],ct=s[3],K=s[7],et=s[11],st=s[15];return r[0]=o*E+a*N+l*P+c*ct,r[4]=o*x+a*L+l*G+c*K,r[8]=o*T+a*z+l*q+c*et,r[12]=o*U+a*O+l*H+c*st,r[1]=f*E+u*N+h*P+d*ct,r[5]=f*x+u*L+h*G+d*K,r[9]=f*T+u*z+h*q+d*et,r[13]=f*U+u*O+h*H+d*st,r[2]=p*E+_*N+g*P+m*ct,r[6]=p*x+_*L+g*G+m*K,r[10]=p*T+_*z+g*q+m*et,r[14]=p*U+_*O+g*H+m*st,r[3]=v*E+A*N+S*P+R*ct,r[7]=v*x+A*L+S*G+R*K,r[11]=v*T+A*z+S*q+R*et,r[15]=v*U+A*O+S*H+R*st,this}multiplyScalar(t){let e=this.elements;return e[0]*=t,e[4]*=t,e[8]*=t,e[12]*=t,e[1]*=t,e[5]*=t,e[9]*=t,e[13]*=t,e[2]*=t,e[6]*=t,e[10]*=t,e[14]*=t,e[3]*=t,e[7]*=t,e[11]*=t,e[15]*=t,this}determinant(){let t=this.elements,e=t[0],n=t[4],s=t[8],r=t[12],o=t[1],a=t[5],l=t[9],c=t[13],f=t[2],u=t[6],h=t[10],d=t[14],p=t[3],_=t[7],g=t[11],m=t[15],v=l*d-c*h,A=a*d-c*u,S=a*h-l*u,R=o*d-c*f,E=o*h-l*f,x=o*u-a*f;return e*(_*v-g*A+m*S)-n*(p*v-g*R+m*E)+s*(p*A-_*R+m*x)-r*(p*S-_*E+g*x)}determinantAffine(){let t=this.elements,e=t[0],n=t[4],s=t[8],r=t[1],o=t[5],a=t[9],l=t[2],c=t[6],f=t[10];return e*(o*f-a*c)-n*(r*f-a*l)+s*(r*c-o*l)}transpose(){let t=this.elements,e;return e=t[1],t[1]=t[4],t[4]=e,e=t[2],t[2]=t[8],t[8]=e,e=t[6],t[6]=t[9],t[9]=e,e=t[3],t[3]=t[12],t[12]=e,e=t[7],t[7]=t[13],t[13]=e,e=t[11],t[11]=t[14],t[14]=e,this}setPosition(t,e,n){let s=this.elements;return t.isVector3?(s[12]=t.x,s[13]=t.y,s[14]=t.z):(s[12]=t,s[13]=e,s[14]=n),this}invert(){let t=this.elements,e=t[0],n=t[1],s=t[2],r=t[3],o=t[4],a=t[5],l=t[6],c=t[7],f=t[8],u=t[9],h=t[10],d=t[11],p=t[12],_=t[13],g=t[14],m=t[15],v=e*a-n*o,A=e*l-s*o,S=e*c-r*o,R=n*l-s*a,E=n*c-r*a,x=s*c-r*l,T=f*_-u*p,U=f*g-h*p,N=f*m-d*p,L=u*g-h*_,z=u*m-d*_,O=h*m-d*g,P=v*O-A*z+S*L+R*N-E*U+x*T;if(P===0)return this.set(0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0);let G=1/P;return t[0]=(a*O-l*z+c*L)*G,t[1]=(s*z-n*O-r*L)*G,t[2]=(_*x-g*E+m*R)*G,t[3]=(h*E-u*x-d*R)*G,t[4]=(l*N-o*O-c*U)*G,t[5]=(e*O-s*N+r*U)*G,t[6]=(g*S-p*x-m*A)*G,t[7]=(f*x-h*S+d*A)*G,t[8]=(o*z-a*N+c*T)*G,t[9]=(n*N-e*z-r*T)*G,t[10]=(p*E-_*S+m*v)*G,t[11]=(u*S-f*E-d*v)*G,t[12]=(a*U-o*L-l*T)*G,t[13]=(e*L-n*U+s*T)*G,t[14]=(_*A-p*R-g*v)*G,t[15]=(f*R-u*A+h*v)*G,this}scale(t){let e=this.elements,n=t.x,s=t.y,r=t.z;return e[0]*=n,e[4]*=s,e[8]*=r,e[1]*=n,e[5]*=s,e[9]*=r,e[2]*=n,e[6]*=s,e[10]*=r,e[3]*=n,e[7]*=s,e[11]*=r,this}getMaxScaleOnAxis(){let t=this.elements,e=t[0]*t[0]+t[1]*t[1]+t[2]*t[2],n=t[4]*t[4]+t[5]*t[5]+t[6]*t[6],s=t[8]*t[8]+t[9]*t[9]+t[10]*t[10];return Math.sqrt(Math.max(e,n,s))}makeTranslation(t,e,n){return t.isVector3?this.set(1,0,0,t.x,0,1,0,t.y,0,0,1,t.z,0,0,0,1):this.set(1,0,0,t,0,1,0,e,0,0,1,n,0,0,0,1),this}makeRotationX(t){let e=Math.cos(t),n=Math.sin(t);return this.set(1,0,0,0,0,e,-n,0,0,n,e,0,0,0,0,1),this}makeRotationY(t){let e=Math.cos(t),n=Math.sin(t);return this.set(e,0,n,0,0,1,0,0,-n,0,e,0,0,0,0,1),this}makeRotationZ(t){let e=Math.cos(t),n=Math.sin(t);return this.set(e,-n,0,0,n,e,0,0,0,0,1,0,0,0,0,1),this}makeRotationAxis(t,e){let n=Math.cos(e),s=Math.sin(e),r=1-n,o=t.x,a=t.y,l=t.z,c=r*o,f=r*a;return this.set(c*o+n,c*a-s*l,c*l+s*a,0,c*a+s*l,f*a+n,f*l-s*o,0,c*l-s*a,f*l+s*o,r*l*l+n,0,0,0,0,1),this}makeScale(t,e,n){return this.set(t,0,0,0,0,e,0,0,0,0,n,0,0,0,0,1),this}makeShear(t,e,n,s,r,o){return this.set(1,n,r,0,t,1,o,0,e,s,1,0,0,0,0,1),this}compose(t,e,n){let s=this.elements,r=e._x,o=e._y,a=e._z,l=e._w,c=r+r,f=o+o,u=a+a,h=r*c,d=r*f,p=r*u,_=o*f,g=o*u,m=a*u,v=l*c,A=l*f,S=l*u,R=n.x,E=n.y,x=n.z;return s[0]=(1-(_+m))*R,s[1]=(d+S)*R,s[2]=(p-A)*R,s[3]=0,s[4]=(d-S)*E,s[5]=(1-(h+m))*E,s[6]=(g+v)*E,s[7]=0,s[8]=(p+A)*x,s[9]=(g-v)*x,s[10]=(1-(h+_))*x,s[11]=0,s[12]=t.x,s[13]=t.y,s[14]=t.z,s[15]=1,this}decompose(t,e,n){let s=this.elements;t.x=s[12],t.y=s[13],t.z=s[14];let r=this.determinantAffine();if(r===0)return n.set(1,1,1),e.identity(),this;let o=$r.set(s[0],s[1],s[2]).length(),a=$r.set(s[4],s[5],s[6]).length(),l=$r.set(s[8],s[9],s[10]).length();r<0&&(o=-o),Di.copy(this);let c=1/o,f=1/a,u=1/l;return Di.elements[0]*=c,Di.elements[1]*=c,Di.elements[2]*=c,Di.elements[4]*=f,Di.elements[5]*=f,Di.elements[6]*=f,Di.elements[8]*=u,Di.elements[9]*=u,Di.elements[10]*=u,e.setFromRotationMatrix(Di),n.x=o,n.y=a,n.z=l,this}makePerspective(t,e,n,s,r,o,a=Ti,l=!1){let c=this.elements,f=2*r/(e-t),u=2*r/(n-s),h=(e+t)/(e-t),d=(n+s)/(n-s),p,_;if(l)p=r/(o-r),_=o*r/(o-r);else if(a===Ti)p=-(o+r)/(o-r),_=-2*o*r/(o-r);else if(a===fo)p=-o/(o-r),_=-o*r/(o-r);else throw new Error("THREE.Matrix4.makePerspective(): Invalid coordinate system: "+a);return c[0]=f,c[4]=0,c[8]=h,c[12]=0,c[1]=0,c[5]=u,c[9]=d,c[13]=0,c[2]=0,c[6]=0,c[10]=p,c[14]=_,c[3]=0,c[7]=0,c[11]=-1,c[15]=0,this}makeOrthographic(t,e,n,s,r,o,a=Ti,l=!1){let c=this.elements,f=2/(e-t),u=2/(n-s),h=-(e+t)/(e-t),d=-(n+s)/(n-s),p,_;if(l)p=1/(o-r),_=o/(o-r);else if(a===Ti)p=-2/(o-r),_=-(o+r)/(o-r);else if(a===fo)p=-1/(o-r),_=-r/(o-r);else throw new Error("THREE.Matrix4.makeOrthographic(): Invalid coordinate system: "+a);return c[0]=f,c[4]=0,c[8]=0,c[12]=h,c[1]=0,c[5]=u,c[9]=0,c[13]=d,c[2]=0,c[6]=0,c[10]=p,c[14]=_,c[3]=0,c[7]=0,c[11]=0,c[15]=1,this}equals(t){let e=this.elements,n=t.elements;for(let s=0;s<16;s++)if(e[s]!==n[s])return!1;return!0}fromArray(t,e=0){for(let n=0;n<16;n++)this.elements[n]=t[n+e];return this}toArray(t=[],e=0){let n=this.elements;return t[e]=n[0],t[e+1]=n[1],t[e+2]=n[2],t[e+3]=n[3],t[e+4]=n[4],t[e+5]=n[5],t[e+6]=n[6],t[e+7]=n[7],t[e+8]=n[8],t[e+9]=n[9],t[e+10]=n[10],t[e+11]=n[11],t[e+12]=n[12],t[e+13]=n[13],t[e+14]=n[14],t[e+15]=n[15],t}},$r=new X,Di=new De,bv=new X(0,0,0),wv=new X(1,1,1),zs=new X,Fl=new X,di=new X,gm=new De,_m=new Qn,ws=class i{constructor(t=0,e=0,n=0,s=i.DEFAULT_ORDER){this.isEuler=!0,this._x=t,this._y=e,this._z=n,this._order=s}get x(){return this._x}set x(t){this._x=t,this._onChangeCallback()}get y(){return this._y}set y(t){this._y=t,this._onChangeCallback()}get z(){return this._z}set z(t){this._z=t,this._onChangeCallback()}get order(){return this._order}set order(t){this._order=t,this._onChangeCallback()}set(t,e,n,s=this._order){return this._x=t,this._y=e,this._z=n,this._order=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._order)}copy(t){return this._x=t._x,this._y=t._y,this._z=t._z,this._order=t._order,this._onChangeCallback(),this}setFromRotationMatrix(t,e=this._order,n=!0){let s=t.elements,r=s[0],o=s[4],a=s[8],l=s[1],c=s[5],f=s[9],u=s[2],h=s[6],d=s[10];switch(e){case"XYZ":this._y=Math.asin(ye(a,-1,1)),Math.abs(a)<.9999999?(this._x=Math.atan2(-f,d),this._z=Math.atan2(-o,r)):(this._x=Math.atan2(h,c),this._z=0);break;case"YXZ":this._x=Math.asin(-ye(f,-1,1)),Math.abs(f)<.9999999?(this._y=Math.atan2(a,d),this._z=Math.atan2(l,c)):(this._y=Math.atan2(-u,r),this._z=0);break;case"ZXY":this._x=Math.asin(ye(h,-1,1)),Math.abs(h)<.9999999?(this._y=Math.atan2(-u,d),this._z=Math.atan2(-o,c)):(this._y=0,this._z=Math.atan2(l,r));break;case"ZYX":this._y=Math.asin(-ye(u,-1,1)),Math.abs(u)<.9999999?(this._x=Math.atan2(h,d),this._z=Math.atan2(l,r)):(this._x=0,this._z=Math.atan2(-o,c));break;case"YZX":this._z=Math.asin(ye(l,-1,1)),Math.abs(l)<.9999999?(this._x=Math.atan2(-f,c),this._y=Math.atan2(-u,r)):(this._x=0,this._y=Math.atan2(a,d));break;case"XZY":this._z=Math.asin(-ye(o,-1,1)),Math.abs(o)<.9999999?(this._x=Math.atan2(h,c),this._y=Math.atan2(a,r)):(this._x=Math.atan2(-f,d),this._y=0);break;default:jt("Euler: .setFromRotationMatrix() encountered an unknown order: "+e)}return this._order=e,n===!0&&this._onChangeCallback(),this}setFromQuaternion(t,e,n){return gm.makeRotationFromQuaternion(t),this.setFromRotationMatrix(gm,e,n)}setFromVector3(t,e=this._order){return this.set(t.x,t.y,t.z,e)}reorder(t){return _m.setFromEuler(this),this.setFromQuaternion(_m,t)}equals(t){return t._x===this._x&&t._y===this._y&&t._z===this._z&&t._order===this._order}fromArray(t){return this._x=t[0],this._y=t[1],this._z=t[2],t[3]!==void 0&&(this._order=t[3]),this._onChangeCallback(),this}toArray(t=[],e=0){return t[e]=this._x,t[e+1]=this._y,t[e+2]=this._z,t[e+3]=this._order,t}_onChange(t){return this._onChangeCallback=t,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._order}};ws.DEFAULT_ORDER="XYZ";var ma=class{constructor(){this.mask=1}set(t){this.mask=(1<<t|0)>>>0}enable(t){this.mask|=1<<t|0}enableAll(){this.mask=-1}toggle(t){this.mask^=1<<t|0}disable(t){this.mask&=~(1<<t|0)}disableAll(){this.mask=0}test(t){return(this.mask&t.mask)!==0}isEnabled(t){return(this.mask&(1<<t|0))!==0}},Tv=0,xm=new X,Yr=new Qn,_s=new De,Ol=new X,Qo=new X,Ev=new X,Av=new Qn,ym=new X(1,0,0),vm=new X(0,1,0),Sm=new X(0,0,1),Mm={type:"added"},Cv={type:"removed"},Zr={type:"childadded",child:null},Nu={type:"childremoved",child:null},Fn=class i extends Oi{constructor(){super(),this.isObject3D=!0,Object.defineProperty(this,"id",{value:Tv++}),this.uuid=tr(),this.name="",this.type="Object3D",this.parent=null,this.children=[],this.up=i.DEFAULT_UP.clone();let t=new X,e=new ws,n=new Qn,s=new X(1,1,1);function r(){n.setFromEuler(e,!1)}function o(){e.setFromQuaternion(n,void 0,!1)}e._onChange(r),n._onChange(o),Object.defineProperties(this,{position:{configurable:!0,enumerable:!0,value:t},rotation:{configurable:!0,enumerable:!0,value:e},quaternion:{configurable:!0,enumerable:!0,value:n},scale:{configurable:!0,enumerable:!0,value:s},modelViewMatrix:{value:new De},normalMatrix:{value:new oe}}),this.matrix=new De,this.matrixWorld=new De,this.matrixAutoUpdate=i.DEFAULT_MATRIX_AUTO_UPDATE,this.matrixWorldAutoUpdate=i.DEFAULT_MATRIX_WORLD_AUTO_UPDATE,this.matrixWorldNeedsUpdate=!1,this.layers=new ma,this.visible=!0,this.castShadow=!1,this.receiveShadow=!1,this.frustumCulled=!0,this.renderOrder=0,this.animations=[],this.customDepthMaterial=void 0,this.customDistanceMaterial=void 0,this.static=!1,this.userData={},this.pivot=null}onBeforeShadow(){}onAfterShadow(){}onBeforeRender(){}onAfterRender(){}applyMatrix4(t){this.matrixAutoUpdate&&this.updateMatrix(),this.matrix.premultiply(t),this.matrix.decompose(this.position,this.quaternion,this.scale),this.pivot!==null&&this.position.copy(this.pivot).applyMatrix4(this.matrix).sub(this.pivot)}applyQuaternion(t){return this.quaternion.premultiply(t),this}setRotationFromAxisAngle(t,e){this.quaternion.setFromAxisAngle(t,e)}setRotationFromEuler(t){this.quaternion.setFromEuler(t,!0)}setRotationFromMatrix(t){this.quaternion.setFromRotationMatrix(t)}setRotationFromQuaternion(t){this.quaternion.copy(t)}rotateOnAxis(t,e){return Yr.setFromAxisAngle(t,e),this.quaternion.multiply(Yr),this}rotateOnWorldAxis(t,e){return Yr.setFromAxisAngle(t,e),this.quaternion.premultiply(Yr),this}rotateX(t){return this.rotateOnAxis(ym,t)}rotateY(t){return this.rotateOnAxis(vm,t)}rotateZ(t){return this.rotateOnAxis(Sm,t)}translateOnAxis(t,e){return xm.copy(t).applyQuaternion(this.quaternion),this.position.add(xm.multiplyScalar(e)),this}translateX(t){return this.translateOnAxis(ym,t)}translateY(t){return this.translateOnAxis(vm,t)}translateZ(t){return this.translateOnAxis(Sm,t)}localToWorld(t){return this.updateWorldMatrix(!0,!1),t.applyMatrix4(this.matrixWorld)}worldToLocal(t){return this.updateWorldMatrix(!0,!1),t.applyMatrix4(_s.copy(this.matrixWorld).invert())}lookAt(t,e,n){t.isVector3?Ol.copy(t):Ol.set(t,e,n);let s=this.parent;this.updateWorldMatrix(!0,!1),Qo.setFromMatrixPosition(this.matrixWorld),this.isCamera||this.isLight?_s.lookAt(Qo,Ol,this.up):_s.lookAt(Ol,Qo,this.up),this.quaternion.setFromRotationMatrix(_s),s&&(_s.extractRotation(s.matrixWorld),Yr.setFromRotationMatrix(_s),this.quaternion.premultiply(Yr.invert()))}add(t){if(arguments.length>1){for(let e=0;e<arguments.length;e++)this.add(arguments[e]);return this}return t===this?(se("Object3D.add: object can't be added as a child of itself.",t),this):(t&&t.isObject3D?(t.removeFromParent(),t.parent=this,this.children.push(t),t.dispatchEvent(Mm),Zr.child=t,this.dispatchEvent(Zr),Zr.child=null):se("Object3D.add: object not an instance of THREE.Object3D.",t),this)}remove(t){if(arguments.length>1){for(let n=0;n<arguments.length;n++)this.remove(arguments[n]);return this}let e=this.children.indexOf(t);return e!==-1&&(t.parent=null,this.children.splice(e,1),t.dispatchEvent(Cv),Nu.child=t,this.dispatchEvent(Nu),Nu.child=null),this}removeFromParent(){let t=this.parent;return t!==null&&t.remove(this),this}clear(){return this.remove(...this.children)}attach(t){return this.updateWorldMatrix(!0,!1),_s.copy(this.matrixWorld).invert(),t.parent!==null&&(t.parent.updateWorldMatrix(!0,!1),_s.multiply(t.parent.matrixWorld)),t.applyMatrix4(_s),t.removeFromParent(),t.parent=this,this.children.push(t),t.updateWorldMatrix(!1,!0),t.dispatchEvent(Mm),Zr.child=t,this.dispatchEvent(Zr),Zr.child=null,this}getObjectById(t){return this.getObjectByProperty("id",t)}getObjectByName(t){return this.getObjectByProperty("name",t)}getObjectByProperty(t,e){if(this[t]===e)return this;for(let n=0,s=this.children.length;n<s;n++){let o=this.children[n].getObjectByProperty(t,e);if(o!==void 0)return o}}getObjectsByProperty(t,e,n=[]){this[t]===e&&n.push(this);let s=this.children;for(let r=0,o=s.length;r<o;r++)s[r].getObjectsByProperty(t,e,n);return n}getWorldPosition(t){return this.updateWorldMatrix(!0,!1),t.setFromMatrixPosition(this.matrixWorld)}getWorldQuaternion(t){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(Qo,t,Ev),t}getWorldScale(t){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(Qo,Av,t),t}getWorldDirection(t){this.updateWorldMatrix(!0,!1);let e=this.matrixWorld.elements;return t.set(e[8],e[9],e[10]).normalize()}raycast(){}intersectsFrustum(){return!0}traverse(t){t(this);let e=this.children;for(let n=0,s=e.length;n<s;n++)e[n].traverse(t)}traverseVisible(t){if(this.visible===!1)return;t(this);let e=this.children;for(let n=0,s=e.length;n<s;n++)e[n].traverseVisible(t)}traverseAncestors(t){let e=this.parent;e!==null&&(t(e),e.traverseAncestors(t))}updateMatrix(){this.matrix.compose(this.position,this.quaternion,this.scale);let t=this.pivot;if(t!==null){let e=t.x,n=t.y,s=t.z,r=this.matrix.elements;r[12]+=e-r[0]*e-r[4]*n-r[8]*s,r[13]+=n-r[1]*e-r[5]*n-r[9]*s,r[14]+=s-r[2]*e-r[6]*n-r[10]*s}this.matrixWorldNeedsUpdate=!0}updateMatrixWorld(t){this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||t)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,t=!0);let e=this.children;for(let n=0,s=e.length;n<s;n++)e[n].updateMatrixWorld(t)}updateWorldMatrix(t,e,n=!1){let s=this.parent;if(t===!0&&s!==null&&s.updateWorldMatrix(!0,!1),this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||n)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,n=!0),e===!0){let r=this.children;for(let o=0,a=r.length;o<a;o++)r[o].updateWorldMatrix(!1,!0,n)}}toJSON(t){let e=t===void 0||typeof t=="string",n={};e&&(t={geometries:{},materials:{},textures:{},images:{},shapes:{},skeletons:{},animations:{},nodes:{}},n.metadata={version:4.7,type:"Object",generator:"Object3D.toJSON"});let s={};s.uuid=this.uuid,s.type=this.type,s.name=this.name,s.castShadow=this.castShadow,s.receiveShadow=this.receiveShadow,s.visible=this.visible,s.frustumCulled=this.frustumCulled,s.renderOrder=this.renderOrder,s.static=this.static,s.matrixAutoUpdate=this.matrixAutoUpdate,Object.keys(this.userData).length>0&&(s.userData=this.userData),s.layers=this.layers.mask,s.matrix=this.matrix.toArray(),s.up=this.up.toArray(),this.pivot!==null&&(s.pivot=this.pivot.toArray()),this.morphTargetDictionary!==void 0&&(s.morphTargetDictionary=Object.assign({},this.morphTargetDictionary)),this.morphTargetInfluences!==void 0&&(s.morphTargetInfluences=this.morphTargetInfluences.slice()),this.isInstancedMesh&&(s.type="InstancedMesh",s.count=this.count,s.instanceMatrix=this.instanceMatrix.toJSON(),this.instanceColor!==null&&(s.instanceColor=this.instanceColor.toJSON())),this.isBatchedMesh&&(s.type="BatchedMesh",s.perObjectFrustumCulled=this.perObjectFrustumCulled,s.sortObjects=this.sortObjects,s.drawRanges=this._drawRanges,s.reservedRanges=this._reservedRanges,s.geometryInfo=this._geometryInfo.map(a=>({...a,boundingBox:a.boundingBox?a.boundingBox.toJSON():void 0,boundingSphere:a.boundingSphere?a.boundingSphere.toJSON():void 0})),s.instanceInfo=this._instanceInfo.map(a=>({...a})),s.availableInstanceIds=this._availableInstanceIds.slice(),s.availableGeometryIds=this._availableGeometryIds.slice(),s.nextIndexStart=this._nextIndexStart,s.nextVertexStart=this._nextVertexStart,s.geometryCount=this._geometryCount,s.maxInstanceCount=this._maxInstanceCount,s.maxVertexCount=this._maxVertexCount,s.maxIndexCount=this._maxIndexCount,s.geometryInitialized=this._geometryInitialized,s.matricesTexture=this._matricesTexture.toJSON(t),s.indirectTexture=this._indirectTexture.toJSON(t),this._colorsTexture!==null&&(s.colorsTexture=this._colorsTexture.toJSON(t)),this.boundingSphere!==null&&(s.boundingSphere=this.boundingSphere.toJSON()),this.boundingBox!==null&&(s.boundingBox=this.boundingBox.toJSON()));function r(a,l){return a[l.uuid]===void 0&&(a[l.uuid]=l.toJSON(t)),l.uuid}if(this.isScene)this.background&&(this.background.isColor?s.background=this.background.toJSON():this.background.isTexture&&(s.background=this.background.toJSON(t).uuid)),this.environment&&this.environment.isTexture&&this.environment.isRenderTargetTexture!==!0&&(s.environment=this.environment.toJSON(t).uuid);else if(this.isMesh||this.isLine||this.isPoints){s.geometry=r(t.geometries,this.geometry);let a=this.geometry.parameters;if(a!==void 0&&a.shapes!==void 0){let l=a.shapes;if(Array.isArray(l))for(let c=0,f=l.length;c<f;c++){let u=l[c];r(t.shapes,u)}else r(t.shapes,l)}}if(this.isSkinnedMesh&&(s.bindMode=this.bindMode,s.bindMatrix=this.bindMatrix.toArray(),this.skeleton!==void 0&&(r(t.skeletons,this.skeleton),s.skeleton=this.skeleton.uuid)),this.material!==void 0)if(Array.isArray(this.material)){let a=[];for(let l=0,c=this.material.length;l<c;l++)a.push(r(t.materials,this.material[l]));s.material=a}else s.material=r(t.materials,this.material);if(this.children.length>0){s.children=[];for(let a=0;a<this.children.length;a++)s.children.push(this.children[a].toJSON(t).object)}if(this.animations.length>0){s.animations=[];for(let a=0;a<this.animations.length;a++){let l=this.animations[a];s.animations.push(r(t.animations,l))}}if(e){let a=o(t.geometries),l=o(t.materials),c=o(t.textures),f=o(t.images),u=o(t.shapes),h=o(t.skeletons),d=o(t.animations),p=o(t.nodes);a.length>0&&(n.geometries=a),l.length>0&&(n.materials=l),c.length>0&&(n.textures=c),f.length>0&&(n.images=f),u.length>0&&(n.shapes=u),h.length>0&&(n.skeletons=h),d.length>0&&(n.animations=d),p.length>0&&(n.nodes=p)}return n.object=s,n;function o(a){let l=[];for(let c in a){let f=a[c];delete f.metadata,l.push(f)}return l}}clone(t){return new this.constructor().copy(this,t)}copy(t,e=!0){if(this.name=t.name,this.up.copy(t.up),this.position.copy(t.position),this.rotation.order=t.rotation.order,this.quaternion.copy(t.quaternion),this.scale.copy(t.scale),this.pivot=t.pivot!==null?t.pivot.clone():null,this.matrix.copy(t.matrix),this.matrixWorld.copy(t.matrixWorld),this.matrixAutoUpdate=t.matrixAutoUpdate,this.matrixWorldAutoUpdate=t.matrixWorldAutoUpdate,this.matrixWorldNeedsUpdate=t.matrixWorldNeedsUpdate,this.layers.mask=t.layers.mask,this.visible=t.visible,this.castShadow=t.castShadow,this.receiveShadow=t.receiveShadow,this.frustumCulled=t.frustumCulled,this.renderOrder=t.renderOrder,this.static=t.static,this.animations=t.animations.slice(),this.userData=JSON.parse(JSON.stringify(t.userData)),e===!0)for(let n=0;n<t.children.length;n++){let s=t.children[n];this.add(s.clone())}return this}dispose(){this.dispatchEvent({type:"dispose"})}};Fn.DEFAULT_UP=new X(0,1,0);Fn.DEFAULT_MATRIX_AUTO_UPDATE=!0;Fn.DEFAULT_MATRIX_WORLD_AUTO_UPDATE=!0;var Bn=class extends Fn{constructor(){super(),this.isGroup=!0,this.type="Group"}},Rv={type:"move"},_o=class{constructor(){this._targetRay=null,this._grip=null,this._hand=null}getHandSpace(){return this._hand===null&&(this._hand=new Bn,this._hand.matrixAutoUpdate=!1,this._hand.visible=!1,this._hand.joints={},this._hand.inputState={pinching:!1}),this._hand}getTargetRaySpace(){return this._targetRay===null&&(this._targetRay=new Bn,this._targetRay.matrixAutoUpdate=!1,this._targetRay.visible=!1,this._targetRay.hasLinearVelocity=!1,this._targetRay.linearVelocity=new X,this._targetRay.hasAngularVelocity=!1,this._targetRay.angularVelocity=new X),this._targetRay}getGripSpace(){return this._grip===null&&(this._grip=new Bn,this._grip.matrixAutoUpdate=!1,this._grip.visible=!1,this._grip.hasLinearVelocity=!1,this._grip.linearVelocity=new X,this._grip.hasAngularVelocity=!1,this._grip.angularVelocity=new X,this._grip.eventsEnabled=!1),this._grip}dispatchEvent(t){return this._targetRay!==null&&this._targetRay.dispatchEvent(t),this._grip!==null&&this._grip.dispatchEvent(t),this._hand!==null&&this._hand.dispatchEvent(t),this}connect(t){if(t&&t.hand){let e=this._hand;if(e)for(let n of t.hand.values())this._getHandJoint(e,n)}return this.dispatchEvent({type:"connected",data:t}),this}disconnect(t){return this.dispatchEvent({type:"disconnected",data:t}),this._targetRay!==null&&(this._targetRay.visible=!1),this._grip!==null&&(this._grip.visible=!1),this._hand!==null&&(this._hand.visible=!1),this}update(t,e,n){let s=null,r=null,o=null,a=this._targetRay,l=this._grip,c=this._hand;if(t&&e.session.visibilityState!=="visible-blurred"){if(c&&t.hand){o=!0;for(let _ of t.hand.values()){let g=e.getJointPose(_,n),m=this._getHandJoint(c,_);g!==null&&(m.matrix.fromArray(g.transform.matrix),m.matrix.decompose(m.position,m.quaternion,m.scale),m.matrixWorldNeedsUpdate=!0,m.jointRadius=g.radius),m.visible=g!==null}let f=c.joints["index-finger-tip"],u=c.joints["thumb-tip"],h=f.position.distanceTo(u.position),d=.02,p=.005;c.inputState.pinching&&h>d+p?(c.inputState.pinching=!1,this.dispatchEvent({type:"pinchend",handedness:t.handedness,target:this})):!c.inputState.pinching&&h<=d-p&&(c.inputState.pinching=!0,this.dispatchEvent({type:"pinchstart",handedness:t.handedness,target:this}))}else l!==null&&t.gripSpace&&(r=e.getPose(t.gripSpace,n),r!==null&&(l.matrix.fromArray(r.transform.matrix),l.matrix.decompose(l.position,l.quaternion,l.scale),l.matrixWorldNeedsUpdate=!0,r.linearVelocity?(l.hasLinearVelocity=!0,l.linearVelocity.copy(r.linearVelocity)):l.hasLinearVelocity=!1,r.angularVelocity?(l.hasAngularVelocity=!0,l.angularVelocity.copy(r.angularVelocity)):l.hasAngularVelocity=!1,l.eventsEnabled&&l.dispatchEvent({type:"gripUpdated",data:t,target:this})));a!==null&&(s=e.getPose(t.targetRaySpace,n),s===null&&r!==null&&(s=r),s!==null&&(a.matrix.fromArray(s.transform.matrix),a.matrix.decompose(a.position,a.quaternion,a.scale),a.matrixWorldNeedsUpdate=!0,s.linearVelocity?(a.hasLinearVelocity=!0,a.linearVelocity.copy(s.linearVelocity)):a.hasLinearVelocity=!1,s.angularVelocity?(a.hasAngularVelocity=!0,a.angularVelocity.copy(s.angularVelocity)):a.hasAngularVelocity=!1,this.dispatchEvent(Rv)))}return a!==null&&(a.visible=s!==null),l!==null&&(l.visible=r!==null),c!==null&&(c.visible=o!==null),this}_getHandJoint(t,e){if(t.joints[e.jointName]===void 0){let n=new Bn;n.matrixAutoUpdate=!1,n.visible=!1,t.joints[e.jointName]=n,t.add(n)}return t.joints[e.jointName]}},wg={aliceblue:15792383,antiquewhite:16444375,aqua:65535,aquamarine:8388564,azure:15794175,beige:16119260,bisque:16770244,black:0,blanchedalmond:16772045,blue:255,blueviolet:9055202,brown:10824234,burlywood:14596231,cadetblue:6266528,chartreuse:8388352,chocolate:13789470,coral:16744272,cornflowerblue:6591981,cornsilk:16775388,crimson:14423100,cyan:65535,darkblue:139,darkcyan:35723,darkgoldenrod:12092939,darkgray:11119017,darkgreen:25600,darkgrey:11119017,darkkhaki:12433259,darkmagenta:9109643,darkolivegreen:5597999,darkorange:16747520,darkorchid:10040012,darkred:9109504,darksalmon:15308410,darkseagreen:9419919,darkslateblue:4734347,darkslategray:3100495,darkslategrey:3100495,darkturquoise:52945,darkviolet:9699539,deeppink:16716947,deepskyblue:49151,dimgray:6908265,dimgrey:6908265,dodgerblue:2003199,firebrick:11674146,floralwhite:16775920,forestgreen:2263842,fuchsia:16711935,gainsboro:14474460,ghostwhite:16316671,gold:16766720,goldenrod:14329120,gray:8421504,green:32768,greenyellow:11403055,grey:8421504,honeydew:15794160,hotpink:16738740,indianred:13458524,indigo:4915330,ivory:16777200,khaki:15787660,lavender:15132410,lavenderblush:16773365,lawngreen:8190976,lemonchiffon:16775885,lightblue:11393254,lightcoral:15761536,lightcyan:14745599,lightgoldenrodyellow:16448210,lightgray:13882323,lightgreen:9498256,lightgrey:13882323,lightpink:16758465,lightsalmon:16752762,lightseagreen:2142890,lightskyblue:8900346,lightslategray:7833753,lightslategrey:7833753,lightsteelblue:11584734,lightyellow:16777184,lime:65280,limegreen:3329330,linen:16445670,magenta:16711935,maroon:8388608,mediumaquamarine:6737322,mediumblue:205,mediumorchid:12211667,mediumpurple:9662683,mediumseagreen:3978097,mediumslateblue:8087790,mediumspringgreen:64154,mediumturquoise:4772300,mediumvioletred:13047173,midnightblue:1644912,mintcream:16121850,mistyrose:16770273,moccasin:16770229,navajowhite:16768685,navy:128,oldlace:16643558,olive:8421376,olivedrab:7048739,orange:16753920,orangered:16729344,orchid:14315734,palegoldenrod:15657130,palegreen:10025880,paleturquoise:11529966,palevioletred:14381203,papayawhip:16773077,peachpuff:16767673,peru:13468991,pink:16761035,plum:14524637,powderblue:11591910,purple:8388736,rebeccapurple:6697881,red:16711680,rosybrown:12357519,royalblue:4286945,saddlebrown:9127187,salmon:16416882,sandybrown:16032864,seagreen:3050327,seashell:16774638,sienna:10506797,silver:12632256,skyblue:8900331,slateblue:6970061,slategray:7372944,slategrey:7372944,snow:16775930,springgreen:65407,steelblue:4620980,tan:13808780,teal:32896,thistle:14204888,tomato:16737095,turquoise:4251856,violet:15631086,wheat:16113331,white:16777215,whitesmoke:16119285,yellow:16776960,yellowgreen:10145074},Vs={h:0,s:0,l:0},Bl={h:0,s:0,l:0};function Uu(i,t,e){return e<0&&(e+=1),e>1&&(e-=1),e<1/6?i+(t-i)*6*e:e<1/2?t:e<2/3?i+(t-i)*6*(2/3-e):i}var ue=class{constructor(t,e,n){return this.isColor=!0,this.r=1,this.g=1,this.b=1,this.set(t,e,n)}set(t,e,n){if(e===void 0&&n===void 0){let s=t;s&&s.isColor?this.copy(s):typeof s=="number"?this.setHex(s):typeof s=="string"&&this.setStyle(s)}else this.setRGB(t,e,n);return this}setScalar(t){return this.r=t,this.g=t,this.b=t,this}setHex(t,e=Jn){return t=Math.floor(t),this.r=(t>>16&255)/255,this.g=(t>>8&255)/255,this.b=(t&255)/255,Me.colorSpaceToWorking(this,e),this}setRGB(t,e,n,s=Me.workingColorSpace){return this.r=t,this.g=e,this.b=n,Me.colorSpaceToWorking(this,s),this}setHSL(t,e,n,s=Me.workingColorSpace){if(t=Nf(t,1),e=ye(e,0,1),n=ye(n,0,1),e===0)this.r=this.g=this.b=n;else{let r=n<=.5?n*(1+e):n+e-n*e,o=2*n-r;this.r=Uu(o,r,t+1/3),this.g=Uu(o,r,t),this.b=Uu(o,r,t-1/3)}return Me.colorSpaceToWorking(this,s),this}setStyle(t,e=Jn){function n(r){r!==void 0&&parseFloat(r)<1&&jt("Color: Alpha component of "+t+" will be ignored.")}let s;if(s=/^(\w+)\(([^\)]*)\)/.exec(t)){let r,o=s[1],a=s[2];switch(o){case"rgb":case"rgba":if(r=/^\s*(\d+)\s*,\s*(\d+)\s*,\s*(\d+)\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return n(r[4]),this.setRGB(Math.min(255,parseInt(r[1],10))/255,Math.min(255,parseInt(r[2],10))/255,Math.min(255,parseInt(r[3],10))/255,e);if(r=/^\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return n(r[4]),this.setRGB(Math.min(100,parseFloat(r[1]))/100,Math.min(100,parseFloat(r[2]))/100,Math.min(100,parseFloat(r[3]))/100,e);break;case"hsl":case"hsla":if(r=/^\s*([+-]?(?:\d+(?:\.\d+)?|\.\d+))\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return n(r[4]),this.setHSL(parseFloat(r[1])/360,parseFloat(r[2])/100,parseFloat(r[3])/100,e);break;default:jt("Color: Unknown color model "+t)}}else if(s=/^\#([A-Fa-f\d]+)$/.exec(t)){let r=s[1],o=r.length;if(o===3)return this.setRGB(parseInt(r.charAt(0),16)/15,parseInt(r.charAt(1),16)/15,parseInt(r.charAt(2),16)/15,e);if(o===6)return this.setHex(parseInt(r,16),e);jt("Color: Invalid hex color "+t)}else if(t&&t.length>0)return this.setColorName(t,e);return this}setColorName(t,e=Jn){let n=wg[t.toLowerCase()];return n!==void 0?this.setHex(n,e):jt("Color: Unknown color "+t),this}clone(){return new this.constructor(this.r,this.g,this.b)}copy(t){return this.r=t.r,this.g=t.g,this.b=t.b,this}copySRGBToLinear(t){return this.r=Ms(t.r),this.g=Ms(t.g),this.b=Ms(t.b),this}copyLinearToSRGB(t){return this.r=ho(t.r),this.g=ho(t.g),this.b=ho(t.b),this}convertSRGBToLinear(){return this.copySRGBToLinear(this),this}convertLinearToSRGB(){return this.copyLinearToSRGB(this),this}getHex(t=Jn){return Me.workingToColorSpace(Gn.copy(this),t),Math.round(ye(Gn.r*255,0,255))*65536+Math.round(ye(Gn.g*255,0,255))*256+Math.round(ye(Gn.b*255,0,255))}getHexString(t=Jn){return("000000"+this.getHex(t).toString(16)).slice(-6)}getHSL(t,e=Me.workingColorSpace){Me.workingToColorSpace(Gn.copy(this),e);let n=Gn.r,s=Gn.g,r=Gn.b,o=Math.max(n,s,r),a=Math.min(n,s,r),l,c,f=(a+o)/2;if(a===o)l=0,c=0;else{let u=o-a;switch(c=f<=.5?u/(o+a):u/(2-o-a),o){case n:l=(s-r)/u+(s<r?6:0);break;case s:l=(r-n)/u+2;break;case r:l=(n-s)/u+4;break}l/=6}return t.h=l,t.s=c,t.l=f,t}getRGB(t,e=Me.workingColorSpace){return Me.workingToColorSpace(Gn.copy(this),e),t.r=Gn.r,t.g=Gn.g,t.b=Gn.b,t}getStyle(t=Jn){Me.workingToColorSpace(Gn.copy(this),t);let e=Gn.r,n=Gn.g,s=Gn.b;return t!==Jn?`color(${t} ${e.toFixed(3)} ${n.toFixed(3)} ${s.toFixed(3)})`:`rgb(${Math.round(e*255)},${Math.round(n*255)},${Math.round(s*255)})`}offsetHSL(t,e,n){return this.getHSL(Vs),this.setHSL(Vs.h+t,Vs.s+e,Vs.l+n)}add(t){return this.r+=t.r,this.g+=t.g,this.b+=t.b,this}addColors(t,e){return this.r=t.r+e.r,this.g=t.g+e.g,this.b=t.b+e.b,this}addScalar(t){return this.r+=t,this.g+=t,this.b+=t,this}sub(t){return this.r=Math.max(0,this.r-t.r),this.g=Math.max(0,this.g-t.g),this.b=Math.max(0,this.b-t.b),this}multiply(t){return this.r*=t.r,this.g*=t.g,this.b*=t.b,this}multiplyScalar(t){return this.r*=t,this.g*=t,this.b*=t,this}lerp(t,e){return this.r+=(t.r-this.r)*e,this.g+=(t.g-this.g)*e,this.b+=(t.b-this.b)*e,this}lerpColors(t,e,n){return this.r=t.r+(e.r-t.r)*n,this.g=t.g+(e.g-t.g)*n,this.b=t.b+(e.b-t.b)*n,this}lerpHSL(t,e){this.getHSL(Vs),t.getHSL(Bl);let n=la(Vs.h,Bl.h,e),s=la(Vs.s,Bl.s,e),r=la(Vs.l,Bl.l,e);return this.setHSL(n,s,r),this}setFromVector3(t){return this.r=t.x,this.g=t.y,this.b=t.z,this}applyMatrix3(t){let e=this.r,n=this.g,s=this.b,r=t.elements;return this.r=r[0]*e+r[3]*n+r[6]*s,this.g=r[1]*e+r[4]*n+r[7]*s,this.b=r[2]*e+r[5]*n+r[8]*s,this}equals(t){return t.r===this.r&&t.g===this.g&&t.b===this.b}fromArray(t,e=0){return this.r=t[e],this.g=t[e+1],this.b=t[e+2],this}toArray(t=[],e=0){return t[e]=this.r,t[e+1]=this.g,t[e+2]=this.b,t}fromBufferAttribute(t,e){return this.r=t.getX(e),this.g=t.getY(e),this.b=t.getZ(e),this}toJSON(){return this.getHex()}*[Symbol.iterator](){yield this.r,yield this.g,yield this.b}},Gn=new ue;ue.NAMES=wg;var ga=class extends Fn{constructor(){super(),this.isScene=!0,this.type="Scene",this.background=null,this.environment=null,this.fog=null,this.backgroundBlurriness=0,this.backgroundIntensity=1,this.backgroundRotation=new ws,this.environmentIntensity=1,this.environmentRotation=new ws,this.overrideMaterial=null,typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}copy(t,e){return super.copy(t,e),this.background=t.background!==null?t.background.clone():null,this.environment=t.environment!==null?t.environment.clone():null,this.fog=t.fog!==null?t.fog.clone():null,this.backgroundBlurriness=t.backgroundBlurriness,this.backgroundIntensity=t.backgroundIntensity,this.backgroundRotation.copy(t.backgroundRotation),this.environmentIntensity=t.environmentIntensity,this.environmentRotation.copy(t.environmentRotation),this.overrideMaterial=t.overrideMaterial!==null?t.overrideMaterial.clone():null,this.matrixAutoUpdate=t.matrixAutoUpdate,this}toJSON(t){let e=super.toJSON(t);return this.fog!==null&&(e.object.fog=this.fog.toJSON()),e.object.backgroundBlurriness=this.backgroundBlurriness,e.object.backgroundIntensity=this.backgroundIntensity,e.object.backgroundRotation=this.backgroundRotation.toArray(),e.object.environmentIntensity=this.environmentIntensity,e.object.environmentRotation=this.environmentRotation.toArray(),e}},Ni=new X,xs=new X,Fu=new X,ys=new X,Jr=new X,Kr=new X,bm=new X,Ou=new X,Bu=new X,ku=new X,zu=new Qe,Vu=new Qe,Gu=new Qe,ts=class i{constructor(t=new X,e=new X,n=new X){this.a=t,this.b=e,this.c=n}static getNormal(t,e,n,s){s.subVectors(n,e),Ni.subVectors(t,e),s.cross(Ni);let r=s.lengthSq();return r>0?s.multiplyScalar(1/Math.sqrt(r)):s.set(0,0,0)}static getBarycoord(t,e,n,s,r){Ni.subVectors(s,e),xs.subVectors(n,e),Fu.subVectors(t,e);let o=Ni.dot(Ni),a=Ni.dot(xs),l=Ni.dot(Fu),c=xs.dot(xs),f=xs.dot(Fu),u=o*c-a*a;if(u===0)return r.set(0,0,0),null;let h=1/u,d=(c*l-a*f)*h,p=(o*f-a*l)*h;return r.set(1-d-p,p,d)}static containsPoint(t,e,n,s){return this.getBarycoord(t,e,n,s,ys)===null?!1:ys.x>=0&&ys.y>=0&&ys.x+ys.y<=1}static getInterpolation(t,e,n,s,r,o,a,l){return this.getBarycoord(t,e,n,s,ys)===null?(l.x=0,l.y=0,"z"in l&&(l.z=0),"w"in l&&(l.w=0),null):(l.setScalar(0),l.addScaledVector(r,ys.x),l.addScaledVector(o,ys.y),l.addScaledVector(a,ys.z),l)}static getInterpolatedAttribute(t,e,n,s,r,o){return zu.setScalar(0),Vu.setScalar(0),Gu.setScalar(0),zu.fromBufferAttribute(t,e),Vu.fromBufferAttribute(t,n),Gu.fromBufferAttribute(t,s),o.setScalar(0),o.addScaledVector(zu,r.x),o.addScaledVector(Vu,r.y),o.addScaledVector(Gu,r.z),o}static isFrontFacing(t,e,n,s){return Ni.subVectors(n,e),xs.subVectors(t,e),Ni.cross(xs).dot(s)<0}set(t,e,n){return this.a.copy(t),this.b.copy(e),this.c.copy(n),this}setFromPointsAndIndices(t,e,n,s){return this.a.copy(t[e]),this.b.copy(t[n]),this.c.copy(t[s]),this}setFromAttributeAndIndices(t,e,n,s){return this.a.fromBufferAttribute(t,e),this.b.fromBufferAttribute(t,n),this.c.fromBufferAttribute(t,s),this}clone(){return new this.constructor().copy(this)}copy(t){return this.a.copy(t.a),this.b.copy(t.b),this.c.copy(t.c),this}getArea(){return Ni.subVectors(this.c,this.b),xs.subVectors(this.a,this.b),Ni.cross(xs).length()*.5}getMidpoint(t){return t.addVectors(this.a,this.b).add(this.c).multiplyScalar(1/3)}getNormal(t){return i.getNormal(this.a,this.b,this.c,t)}getPlane(t){return t.setFromCoplanarPoints(this.a,this.b,this.c)}getBarycoord(t,e){return i.getBarycoord(t,this.a,this.b,this.c,e)}getInterpolation(t,e,n,s,r){return i.getInterpolation(t,this.a,this.b,this.c,e,n,s,r)}containsPoint(t){return i.containsPoint(t,this.a,this.b,this.c)}isFrontFacing(t){return i.isFrontFacing(this.a,this.b,this.c,t)}intersectsBox(t){return t.intersectsTriangle(this)}closestPointToPoint(t,e){let n=this.a,s=this.b,r=this.c,o,a;Jr.subVectors(s,n),Kr.subVectors(r,n),Ou.subVectors(t,n);let l=Jr.dot(Ou),c=Kr.dot(Ou);if(l<=0&&c<=0)return e.copy(n);Bu.subVectors(t,s);let f=Jr.dot(Bu),u=Kr.dot(Bu);if(f>=0&&u<=f)return e.copy(s);let h=l*u-f*c;if(h<=0&&l>=0&&f<=0&&l-f>0)return o=l/(l-f),e.copy(n).addScaledVector(Jr,o);ku.subVectors(t,r);let d=Jr.dot(ku),p=Kr.dot(ku);if(p>=0&&d<=p)return e.copy(r);let _=d*c-l*p;if(_<=0&&c>=0&&p<=0)return a=c/(c-p),e.copy(n).addScaledVector(Kr,a);let g=f*p-d*u;if(g<=0&&u-f>=0&&d-p>=0)return bm.subVectors(r,s),a=(u-f)/(u-f+(d-p)),e.copy(s).addScaledVector(bm,a);let m=1/(g+_+h);return o=_*m,a=h*m,e.copy(n).addScaledVector(Jr,o).addScaledVector(Kr,a)}equals(t){return t.a.equals(this.a)&&t.b.equals(this.b)&&t.c.equals(this.c)}},Xs=class{constructor(t=new X(1/0,1/0,1/0),e=new X(-1/0,-1/0,-1/0)){this.isBox3=!0,this.min=t,this.max=e}set(t,e){return this.min.copy(t),this.max.copy(e),this}setFromArray(t){this.makeEmpty();for(let e=0,n=t.length;e<n;e+=3)this.expandByPoint(Ui.fromArray(t,e));return this}setFromBufferAttribute(t){this.makeEmpty();for(let e=0,n=t.count;e<n;e++)this.expandByPoint(Ui.fromBufferAttribute(t,e));return this}setFromPoints(t){this.makeEmpty();for(let e=0,n=t.length;e<n;e++)this.expandByPoint(t[e]);return this}setFromCenterAndSize(t,e){let n=Ui.copy(e).multiplyScalar(.5);return this.min.copy(t).sub(n),this.max.copy(t).add(n),this}setFromObject(t,e=!1){return this.makeEmpty(),this.expandByObject(t,e)}clone(){return new this.constructor().copy(this)}copy(t){return this.min.copy(t.min),this.max.copy(t.max),this}makeEmpty(){return this.min.x=this.min.y=this.min.z=1/0,this.max.x=this.max.y=this.max.z=-1/0,this}isEmpty(){return this.max.x<this.min.x||this.max.y<this.min.y||this.max.z<this.min.z}getCenter(t){return this.isEmpty()?t.set(0,0,0):t.addVectors(this.min,this.max).multiplyScalar(.5)}getSize(t){return this.isEmpty()?t.set(0,0,0):t.subVectors(this.max,this.min)}expandByPoint(t){return this.min.min(t),this.max.max(t),this}expandByVector(t){return this.min.sub(t),this.max.add(t),this}expandByScalar(t){return this.min.addScalar(-t),this.max.addScalar(t),this}expandByObject(t,e=!1){t.updateWorldMatrix(!1,!1);let n=t.geometry;if(n!==void 0){let r=n.getAttribute("position");if(e===!0&&r!==void 0&&t.isInstancedMesh!==!0&&t.isBatchedMesh!==!0)for(let o=0,a=r.count;o<a;o++)t.isMesh===!0?t.getVertexPosition(o,Ui):Ui.fromBufferAttribute(r,o),Ui.applyMatrix4(t.matrixWorld),this.expandByPoint(Ui);else t.boundingBox!==void 0?(t.boundingBox===null&&t.computeBoundingBox(),kl.copy(t.boundingBox)):(n.boundingBox===null&&n.computeBoundingBox(),kl.copy(n.boundingBox)),kl.applyMatrix4(t.matrixWorld),this.union(kl)}let s=t.children;for(let r=0,o=s.length;r<o;r++)this.expandByObject(s[r],e);return this}containsPoint(t){return t.x>=this.min.x&&t.x<=this.max.x&&t.y>=this.min.y&&t.y<=this.max.y&&t.z>=this.min.z&&t.z<=this.max.z}containsBox(t){return this.min.x<=t.min.x&&t.max.x<=this.max.x&&this.min.y<=t.min.y&&t.max.y<=this.max.y&&this.min.z<=t.min.z&&t.max.z<=this.max.z}getParameter(t,e){return e.set((t.x-this.min.x)/(this.max.x-this.min.x),(t.y-this.min.y)/(this.max.y-this.min.y),(t.z-this.min.z)/(this.max.z-this.min.z))}intersectsBox(t){return t.max.x>=this.min.x&&t.min.x<=this.max.x&&t.max.y>=this.min.y&&t.min.y<=this.max.y&&t.max.z>=this.min.z&&t.min.z<=this.max.z}intersectsSphere(t){return this.clampPoint(t.center,Ui),Ui.distanceToSquared(t.center)<=t.radius*t.radius}intersectsPlane(t){let e,n;return t.normal.x>0?(e=t.normal.x*this.min.x,n=t.normal.x*this.max.x):(e=t.normal.x*this.max.x,n=t.normal.x*this.min.x),t.normal.y>0?(e+=t.normal.y*this.min.y,n+=t.normal.y*this.max.y):(e+=t.normal.y*this.max.y,n+=t.normal.y*this.min.y),t.normal.z>0?(e+=t.normal.z*this.min.z,n+=t.normal.z*this.max.z):(e+=t.normal.z*this.max.z,n+=t.normal.z*this.min.z),e<=-t.constant&&n>=-t.constant}intersectsTriangle(t){if(this.isEmpty())return!1;this.getCenter(ta),zl.subVectors(this.max,ta),jr.subVectors(t.a,ta),Qr.subVectors(t.b,ta),to.subVectors(t.c,ta),Gs.subVectors(Qr,jr),Hs.subVectors(to,Qr),hr.subVectors(jr,to);let e=[0,-Gs.z,Gs.y,0,-Hs.z,Hs.y,0,-hr.z,hr.y,Gs.z,0,-Gs.x,Hs.z,0,-Hs.x,hr.z,0,-hr.x,-Gs.y,Gs.x,0,-Hs.y,Hs.x,0,-hr.y,hr.x,0];return!Hu(e,jr,Qr,to,zl)||(e=[1,0,0,0,1,0,0,0,1],!Hu(e,jr,Qr,to,zl))?!1:(Vl.crossVectors(Gs,Hs),e=[Vl.x,Vl.y,Vl.z],Hu(e,jr,Qr,to,zl))}clampPoint(t,e){return e.copy(t).clamp(this.min,this.max)}distanceToPoint(t){return this.clampPoint(t,Ui).distanceTo(t)}getBoundingSphere(t){return this.isEmpty()?t.makeEmpty():(this.getCenter(t.center),t.radius=this.getSize(Ui).length()*.5),t}intersect(t){return this.min.max(t.min),this.max.min(t.max),this.isEmpty()&&this.makeEmpty(),this}union(t){return this.min.min(t.min),this.max.max(t.max),this}applyMatrix4(t){return this.isEmpty()?this:(vs[0].set(this.min.x,this.min.y,this.min.z).applyMatrix4(t),vs[1].set(this.min.x,this.min.y,this.max.z).applyMatrix4(t),vs[2].set(this.min.x,this.max.y,this.min.z).applyMatrix4(t),vs[3].set(this.min.x,this.max.y,this.max.z).applyMatrix4(t),vs[4].set(this.max.x,this.min.y,this.min.z).applyMatrix4(t),vs[5].set(this.max.x,this.min.y,this.max.z).applyMatrix4(t),vs[6].set(this.max.x,this.max.y,this.min.z).applyMatrix4(t),vs[7].set(this.max.x,this.max.y,this.max.z).applyMatrix4(t),this.setFromPoints(vs),this)}translate(t){return this.min.add(t),this.max.add(t),this}equals(t){return t.min.equals(this.min)&&t.max.equals(this.max)}toJSON(){return{min:this.min.toArray(),max:this.max.toArray()}}fromJSON(t){return this.min.fromArray(t.min),this.max.fromArray(t.max),this}},vs=[new X,new X,new X,new X,new X,new X,new X,new X],Ui=new X,kl=new Xs,jr=new X,Qr=new X,to=new X,Gs=new X,Hs=new X,hr=new X,ta=new X,zl=new X,Vl=new X,ur=new X;function Hu(i,t,e,n,s){for(let r=0,o=i.length-3;r<=o;r+=3){ur.fromArray(i,r);let a=s.x*Math.abs(ur.x)+s.y*Math.abs(ur.y)+s.z*Math.abs(ur.z),l=t.dot(ur),c=e.dot(ur),f=n.dot(ur);if(Math.max(-Math.max(l,c,f),Math.min(l,c,f))>a)return!1}return!0}var _n=new X,Gl=new Jt,Pv=0,Fi=class extends Oi{constructor(t,e,n=!1){if(super(),Array.isArray(t))throw new TypeError("THREE.BufferAttribute: array should be a Typed Array.");this.isBufferAttribute=!0,Object.defineProperty(this,"id",{value:Pv++}),this.name="",this.array=t,this.itemSize=e,this.count=t!==void 0?t.length/e:0,this.normalized=n,this.usage=Lf,this.updateRanges=[],this.gpuType=ki,this.version=0,this._normalizationScale=t!==void 0?Ih(t):void 0}onUploadCallback(){}set needsUpdate(t){t===!0&&this.version++}setUsage(t){return this.usage=t,this}addUpdateRange(t,e){this.updateRanges.push({start:t,count:e})}clearUpdateRanges(){this.updateRanges.length=0}copy(t){return this.name=t.name,this.array=new t.array.constructor(t.array),this.itemSize=t.itemSize,this.count=t.count,this.normalized=t.normalized,this.usage=t.usage,this.gpuType=t.gpuType,this._normalizationScale=t._normalizationScale,this}copyAt(t,e,n){t*=this.itemSize,n*=e.itemSize;for(let s=0,r=this.itemSize;s<r;s++)this.array[t+s]=e.array[n+s];return this}copyArray(t){return this.array.set(t),this}applyMatrix3(t){if(this.itemSize===2)for(let e=0,n=this.count;e<n;e++)Gl.fromBufferAttribute(this,e),Gl.applyMatrix3(t),this.setXY(e,Gl.x,Gl.y);else if(this.itemSize===3)for(let e=0,n=this.count;e<n;e++)_n.fromBufferAttribute(this,e),_n.applyMatrix3(t),this.setXYZ(e,_n.x,_n.y,_n.z);return this}applyMatrix4(t){for(let e=0,n=this.count;e<n;e++)_n.fromBufferAttribute(this,e),_n.applyMatrix4(t),this.setXYZ(e,_n.x,_n.y,_n.z);return this}applyNormalMatrix(t){for(let e=0,n=this.count;e<n;e++)_n.fromBufferAttribute(this,e),_n.applyNormalMatrix(t),this.setXYZ(e,_n.x,_n.y,_n.z);return this}transformDirection(t){for(let e=0,n=this.count;e<n;e++)_n.fromBufferAttribute(this,e),_n.transformDirection(t),this.setXYZ(e,_n.x,_n.y,_n.z);return this}set(t,e=0){return this.array.set(t,e),this}getComponent(t,e){let n=this.array[t*this.itemSize+e];return this.normalized&&(n=this._denormalize(n)),n}setComponent(t,e,n){return this.normalized&&(n=this._normalize(n)),this.array[t*this.itemSize+e]=n,this}getX(t){let e=this.array[t*this.itemSize];return this.normalized&&(e=this._denormalize(e)),e}setX(t,e){return this.normalized&&(e=this._normalize(e)),this.array[t*this.itemSize]=e,this}getY(t){let e=this.array[t*this.itemSize+1];return this.normalized&&(e=this._denormalize(e)),e}setY(t,e){return this.normalized&&(e=this._normalize(e)),this.array[t*this.itemSize+1]=e,this}getZ(t){let e=this.array[t*this.itemSize+2];return this.normalized&&(e=this._denormalize(e)),e}setZ(t,e){return this.normalized&&(e=this._normalize(e)),this.array[t*this.itemSize+2]=e,this}getW(t){let e=this.array[t*this.itemSize+3];return this.normalized&&(e=this._denormalize(e)),e}setW(t,e){return this.normalized&&(e=this._normalize(e)),this.array[t*this.itemSize+3]=e,this}setXY(t,e,n){return t*=this.itemSize,this.normalized&&(e=this._normalize(e),n=this._normalize(n)),this.array[t+0]=e,this.array[t+1]=n,this}setXYZ(t,e,n,s){return t*=this.itemSize,this.normalized&&(e=this._normalize(e),n=this._normalize(n),s=this._normalize(s)),this.array[t+0]=e,this.array[t+1]=n,this.array[t+2]=s,this}setXYZW(t,e,n,s,r){return t*=this.itemSize,this.normalized&&(e=this._normalize(e),n=this._normalize(n),s=this._normalize(s),r=this._normalize(r)),this.array[t+0]=e,this.array[t+1]=n,this.array[t+2]=s,this.array[t+3]=r,this}onUpload(t){return this.onUploadCallback=t,this}clone(){return new this.constructor(this.array,this.itemSize).copy(this)}toJSON(){let t={itemSize:this.itemSize,type:this.array.constructor.name,array:Array.from(this.array),normalized:this.normalized};return t.name=this.name,t.usage=this.usage,t.gpuType=this.gpuType,t}dispose(){this.dispatchEvent({type:"dispose"})}_denormalize(t){let e=this._normalizationScale;return e!==void 0?Math.max(t/e,-1):Ff(t,this.array)}_normalize(t){let e=this._normalizationScale;return e!==void 0?Math.round(t*e):Of(t,this.array)}};var _a=class extends Fi{constructor(t,e,n){super(new Uint16Array(t),e,n)}};var xa=class extends Fi{constructor(t,e,n){super(new Uint32Array(t),e,n)}};var Re=class extends Fi{constructor(t,e,n){super(new Float32Array(t),e,n)}},Iv=new Xs,ea=new X,Wu=new X,pr=class{constructor(t=new X,e=-1){this.isSphere=!0,this.center=t,this.radius=e}set(t,e){return this.center.copy(t),this.radius=e,this}setFromPoints(t,e){let n=this.center;e!==void 0?n.copy(e):Iv.setFromPoints(t).getCenter(n);let s=0;for(let r=0,o=t.length;r<o;r++)s=Math.max(s,n.distanceToSquared(t[r]));return this.radius=Math.sqrt(s),this}copy(t){return this.center.copy(t.center),this.radius=t.radius,this}isEmpty(){return this.radius<0}makeEmpty(){return this.center.set(0,0,0),this.radius=-1,this}containsPoint(t){return t.distanceToSquared(this.center)<=this.radius*this.radius}distanceToPoint(t){return t.distanceTo(this.center)-this.radius}intersectsSphere(t){let e=this.radius+t.radius;return t.center.distanceToSquared(this.center)<=e*e}intersectsBox(t){return t.intersectsSphere(this)}intersectsPlane(t){return Math.abs(t.distanceToPoint(this.center))<=this.radius}clampPoint(t,e){let n=this.center.distanceToSquared(t);return e.copy(t),n>this.radius*this.radius&&(e.sub(this.center).normalize(),e.multiplyScalar(this.radius).add(this.center)),e}getBoundingBox(t){return this.isEmpty()?(t.makeEmpty(),t):(t.set(this.center,this.center),t.expandByScalar(this.radius),t)}applyMatrix4(t){return this.center.applyMatrix4(t),this.radius=this.radius*t.getMaxScaleOnAxis(),this}translate(t){return this.center.add(t),this}expandByPoint(t){if(this.isEmpty())return this.center.copy(t),this.radius=0,this;ea.subVectors(t,this.center);let e=ea.lengthSq();if(e>this.radius*this.radius){let n=Math.sqrt(e),s=(n-this.radius)*.5;this.center.addScaledVector(ea,s/n),this.radius+=s}return this}union(t){return t.isEmpty()?this:this.isEmpty()?(this.copy(t),this):(this.center.equals(t.center)===!0?this.radius=Math.max(this.radius,t.radius):(Wu.subVectors(t.center,this.center).setLength(t.radius),this.expandByPoint(ea.copy(t.center).add(Wu)),this.expandByPoint(ea.copy(t.center).sub(Wu))),this)}equals(t){return t.center.equals(this.center)&&t.radius===this.radius}clone(){return new this.constructor().copy(this)}toJSON(){return{radius:this.radius,center:this.center.toArray()}}fromJSON(t){return this.radius=t.radius,this.center.fromArray(t.center),this}},Lv=0,wi=new De,Xu=new Fn,eo=new X,pi=new Xs,na=new Xs,Nn=new X,an=class i extends Oi{constructor(){super(),this.isBufferGeometry=!0,Object.defineProperty(this,"id",{value:Lv++}),this.uuid=tr(),this.name="",this.type="BufferGeometry",this.index=null,this.indirect=null,this.indirectOffset=0,this.attributes={},this.morphAttributes={},this.morphTargetsRelative=!1,this.groups=[],this.boundingBox=null,this.boundingSphere=null,this.drawRange={start:0,count:1/0},this.userData={},this._transformed=!1}getIndex(){return this.index}setIndex(t){return Array.isArray(t)?this.index=new(iv(t)?xa:_a)(t,1):this.index=t,this}setIndirect(t,e=0){return this.indirect=t,this.indirectOffset=e,this}getIndirect(){return this.indirect}getAttribute(t){return this.attributes[t]}setAttribute(t,e){return this.attributes[t]=e,this}deleteAttribute(t){return delete this.attributes[t],this}hasAttribute(t){return this.attributes[t]!==void 0}addGroup(t,e,n=0){this.groups.push({start:t,count:e,materialIndex:n})}clearGroups(){this.groups=[]}setDrawRange(t,e){this.drawRange.start=t,this.drawRange.count=e}applyMatrix4(t){let e=this.attributes.position;e!==void 0&&(e.applyMatrix4(t),e.needsUpdate=!0);let n=this.attributes.normal;if(n!==void 0){let r=new oe().getNormalMatrix(t);n.applyNormalMatrix(r),n.needsUpdate=!0}let s=this.attributes.tangent;return s!==void 0&&(s.transformDirection(t),s.needsUpdate=!0),this.boundingBox!==null&&this.computeBoundingBox(),this.boundingSphere!==null&&this.computeBoundingSphere(),this._transformed=!0,this}applyQuaternion(t){return wi.makeRotationFromQuaternion(t),this.applyMatrix4(wi),this}rotateX(t){return wi.makeRotationX(t),this.applyMatrix4(wi),this}rotateY(t){return wi.makeRotationY(t),this.applyMatrix4(wi),this}rotateZ(t){return wi.makeRotationZ(t),this.applyMatrix4(wi),this}translate(t,e,n){return wi.makeTranslation(t,e,n),this.applyMatrix4(wi),this}scale(t,e,n){return wi.makeScale(t,e,n),this.applyMatrix4(wi),this}lookAt(t){return Xu.lookAt(t),Xu.updateMatrix(),this.applyMatrix4(Xu.matrix),this}center(){return this.computeBoundingBox(),this.boundingBox.getCenter(eo).negate(),this.translate(eo.x,eo.y,eo.z),this}setFromPoints(t){let e=this.getAttribute("position");if(e===void 0){let n=[];for(let s=0,r=t.length;s<r;s++){let o=t[s];n.push(o.x,o.y,o.z||0)}this.setAttribute("position",new Re(n,3))}else{let n=Math.min(t.length,e.count);for(let s=0;s<n;s++){let r=t[s];e.setXYZ(s,r.x,r.y,r.z||0)}t.length>e.count&&jt("BufferGeometry: Buffer size too small for points data. Use .dispose() and create a new geometry."),e.needsUpdate=!0}return this}computeBoundingBox(){this.boundingBox===null&&(this.boundingBox=new Xs);let t=this.attributes.position,e=this.morphAttributes.position;if(t&&t.isGLBufferAttribute){se("BufferGeometry.computeBoundingBox(): GLBufferAttribute requires a manual bounding box.",this),this.boundingBox.set(new X(-1/0,-1/0,-1/0),new X(1/0,1/0,1/0));return}if(t!==void 0){if(this.boundingBox.setFromBufferAttribute(t),e)for(let n=0,s=e.length;n<s;n++){let r=e[n];pi.setFromBufferAttribute(r),this.morphTargetsRelative?(Nn.addVectors(this.boundingBox.min,pi.min),this.boundingBox.expandByPoint(Nn),Nn.addVectors(this.boundingBox.max,pi.max),this.boundingBox.expandByPoint(Nn)):(this.boundingBox.expandByPoint(pi.min),this.boundingBox.expandByPoint(pi.max))}}else this.boundingBox.makeEmpty();(isNaN(this.boundingBox.min.x)||isNaN(this.boundingBox.min.y)||isNaN(this.boundingBox.min.z))&&se('BufferGeometry.computeBoundingBox(): Computed min/max have NaN values. The "position" attribute is likely to have NaN values.',this)}computeBoundingSphere(){this.boundingSphere===null&&(this.boundingSphere=new pr);let t=this.attributes.position,e=this.morphAttributes.position;if(t&&t.isGLBufferAttribute){se("BufferGeometry.computeBoundingSphere(): GLBufferAttribute requires a manual bounding sphere.",this),this.boundingSphere.set(new X,1/0);return}if(t){let n=this.boundingSphere.center;if(pi.setFromBufferAttribute(t),e)for(let r=0,o=e.length;r<o;r++){let a=e[r];na.setFromBufferAttribute(a),this.morphTargetsRelative?(Nn.addVectors(pi.min,na.min),pi.expandByPoint(Nn),Nn.addVectors(pi.max,na.max),pi.expandByPoint(Nn)):(pi.expandByPoint(na.min),pi.expandByPoint(na.max))}pi.getCenter(n);let s=0;for(let r=0,o=t.count;r<o;r++)Nn.fromBufferAttribute(t,r),s=Math.max(s,n.distanceToSquared(Nn));if(e)for(let r=0,o=e.length;r<o;r++){let a=e[r],l=this.morphTargetsRelative;for(let c=0,f=a.count;c<f;c++)Nn.fromBufferAttribute(a,c),l&&(eo.fromBufferAttribute(t,c),Nn.add(eo)),s=Math.max(s,n.distanceToSquared(Nn))}this.boundingSphere.radius=Math.sqrt(s),isNaN(this.boundingSphere.radius)&&se('BufferGeometry.computeBoundingSphere(): Computed radius is NaN. The "position" attribute is likely to have NaN values.',this)}}computeTangents(){let t=this.index,e=this.attributes;if(t===null||e.position===void 0||e.normal===void 0||e.uv===void 0){se("BufferGeometry: .computeTangents() failed. Missing required attributes (index, position, normal or uv)");return}let n=e.position,s=e.normal,r=e.uv,o=this.getAttribute("tangent");(o===void 0||o.count!==n.count)&&(o=new Fi(new Float32Array(4*n.count),4),this.setAttribute("tangent",o));let a=[],l=[],c=new Uint8Array(n.count);for(let U=0;U<n.count;U++)a[U]=new X,l[U]=new X;let f=new X,u=new X,h=new X,d=new Jt,p=new Jt,_=new Jt,g=new X,m=new X;function v(U,N,L){c[U]=c[N]=c[L]=1,f.fromBufferAttribute(n,U),u.fromBufferAttribute(n,N),h.fromBufferAttribute(n,L),d.fromBufferAttribute(r,U),p.fromBufferAttribute(r,N),_.fromBufferAttribute(r,L),u.sub(f),h.sub(f),p.sub(d),_.sub(d);let z=1/(p.x*_.y-_.x*p.y);isFinite(z)&&(g.copy(u).multiplyScalar(_.y).addScaledVector(h,-p.y).multiplyScalar(z),m.copy(h).multiplyScalar(p.x).addScaledVector(u,-_.x).multiplyScalar(z),a[U].add(g),a[N].add(g),a[L].add(g),l[U].add(m),l[N].add(m),l[L].add(m))}let A=this.groups;A.length===0&&(A=[{start:0,count:t.count}]);for(let U=0,N=A.length;U<N;++U){let L=A[U],z=L.start,O=L.count;for(let P=z,G=z+O;P<G;P+=3)v(t.getX(P+0),t.getX(P+1),t.getX(P+2))}let S=new X,R=new X,E=new X,x=new X;function T(U){E.fromBufferAttribute(s,U),x.copy(E);let N=a[U];S.copy(N),S.sub(E.multiplyScalar(E.dot(N))).normalize(),R.crossVectors(x,N);let z=R.dot(l[U])<0?-1:1;o.setXYZW(U,S.x,S.y,S.z,z)}for(let U=0,N=n.count;U<N;++U)c[U]&&T(U);this._transformed=!0}computeVertexNormals(){let t=this.index,e=this.getAttribute("position");if(e!==void 0){let n=this.getAttribute("normal");if(n===void 0||n.count!==e.count)n=new Fi(new Float32Array(e.count*3),3),this.setAttribute("normal",n);else for(let h=0,d=n.count;h<d;h++)n.setXYZ(h,0,0,0);let s=new X,r=new X,o=new X,a=new X,l=new X,c=new X,f=new X,u=new X;if(t)for(let h=0,d=t.count;h<d;h+=3){let p=t.getX(h+0),_=t.getX(h+1),g=t.getX(h+2);s.fromBufferAttribute(e,p),r.fromBufferAttribute(e,_),o.fromBufferAttribute(e,g),f.subVectors(o,r),u.subVectors(s,r),f.cross(u),a.fromBufferAttribute(n,p),l.fromBufferAttribute(n,_),c.fromBufferAttribute(n,g),a.add(f),l.add(f),c.add(f),n.setXYZ(p,a.x,a.y,a.z),n.setXYZ(_,l.x,l.y,l.z),n.setXYZ(g,c.x,c.y,c.z)}else for(let h=0,d=e.count;h<d;h+=3)s.fromBufferAttribute(e,h+0),r.fromBufferAttribute(e,h+1),o.fromBufferAttribute(e,h+2),f.subVectors(o,r),u.subVectors(s,r),f.cross(u),n.setXYZ(h+0,f.x,f.y,f.z),n.setXYZ(h+1,f.x,f.y,f.z),n.setXYZ(h+2,f.x,f.y,f.z);this.normalizeNormals(),n.needsUpdate=!0}}normalizeNormals(){let t=this.attributes.normal;for(let e=0,n=t.count;e<n;e++)Nn.fromBufferAttribute(t,e),Nn.normalize(),t.setXYZ(e,Nn.x,Nn.y,Nn.z)}toNonIndexed(){function t(a,l){let c=a.array,f=a.itemSize,u=a.normalized,h=new c.constructor(l.length*f),d=0,p=0;for(let _=0,g=l.length;_<g;_++){a.isInterleavedBufferAttribute?d=l[_]*a.data.stride+a.offset:d=l[_]*f;for(let m=0;m<f;m++)h[p++]=c[d++]}return new Fi(h,f,u)}if(this.index===null)return jt("BufferGeometry.toNonIndexed(): BufferGeometry is already non-indexed."),this;let e=new i,n=this.index.array,s=this.attributes;for(let a in s){let l=s[a],c=t(l,n);e.setAttribute(a,c)}let r=this.morphAttributes;for(let a in r){let l=[],c=r[a];for(let f=0,u=c.length;f<u;f++){let h=c[f],d=t(h,n);l.push(d)}e.morphAttributes[a]=l}e.morphTargetsRelative=this.morphTargetsRelative;let o=this.groups;for(let a=0,l=o.length;a<l;a++){let c=o[a];e.addGroup(c.start,c.count,c.materialIndex)}return e}toJSON(){let t={metadata:{version:4.7,type:"BufferGeometry",generator:"BufferGeometry.toJSON"}};if(t.uuid=this.uuid,t.type=this.parameters!==void 0&&this._transformed===!0?"BufferGeometry":this.type,t.name=this.name,Object.keys(this.userData).length>0&&(t.userData=this.userData),this.parameters!==void 0&&this._transformed!==!0){let l=this.parameters;for(let c in l)l[c]!==void 0&&(t[c]=l[c]);return t}t.data={attributes:{}};let e=this.index;e!==null&&(t.data.index={type:e.array.constructor.name,array:Array.prototype.slice.call(e.array)});let n=this.attributes;for(let l in n){let c=n[l];t.data.attributes[l]=c.toJSON(t.data)}let s={},r=!1;for(let l in this.morphAttributes){let c=this.morphAttributes[l],f=[];for(let u=0,h=c.length;u<h;u++){let d=c[u];f.push(d.toJSON(t.data))}f.length>0&&(s[l]=f,r=!0)}r&&(t.data.morphAttributes=s,t.data.morphTargetsRelative=this.morphTargetsRelative);let o=this.groups;o.length>0&&(t.data.groups=JSON.parse(JSON.stringify(o)));let a=this.boundingSphere;return a!==null&&(t.data.boundingSphere=a.toJSON()),t}clone(){return new this.constructor().copy(this)}copy(t){this.index=null,this.attributes={},this.morphAttributes={},this.groups=[],this.boundingBox=null,this.boundingSphere=null;let e={};this.name=t.name;let n=t.index;n!==null&&this.setIndex(n.clone());let s=t.attributes;for(let c in s){let f=s[c];this.setAttribute(c,f.clone(e))}let r=t.morphAttributes;for(let c in r){let f=[],u=r[c];for(let h=0,d=u.length;h<d;h++)f.push(u[h].clone(e));this.morphAttributes[c]=f}this.morphTargetsRelative=t.morphTargetsRelative;let o=t.groups;for(let c=0,f=o.length;c<f;c++){let u=o[c];this.addGroup(u.start,u.count,u.materialIndex)}let a=t.boundingBox;a!==null&&(this.boundingBox=a.clone());let l=t.boundingSphere;return l!==null&&(this.boundingSphere=l.clone()),this.drawRange.start=t.drawRange.start,this.drawRange.count=t.drawRange.count,this.userData=t.userData,this._transformed=t._transformed,this}dispose(){this.dispatchEvent({type:"dispose"})}},Tc=class{constructor(t,e){this.isInterleavedBuffer=!0,this.array=t,this.stride=e,this.count=t!==void 0?t.length/e:0,this.usage=Lf,this.updateRanges=[],this.version=0,this.uuid=tr()}onUploadCallback(){}set needsUpdate(t){t===!0&&this.version++}setUsage(t){return this.usage=t,this}addUpdateRange(t,e){this.updateRanges.push({start:t,count:e})}clearUpdateRanges(){this.updateRanges.length=0}copy(t){return this.array=new t.array.constructor(t.array),this.count=t.count,this.stride=t.stride,this.usage=t.usage,this}copyAt(t,e,n){t*=this.stride,n*=e.stride;for(let s=0,r=this.stride;s<r;s++)this.array[t+s]=e.array[n+s];return this}set(t,e=0){return this.array.set(t,e),this}clone(t){t.arrayBuffers===void 0&&(t.arrayBuffers={});let e=wm(this.array);t.arrayBuffers[e]===void 0&&(t.arrayBuffers[e]=this.array.slice(0).buffer);let n=new this.array.constructor(t.arrayBuffers[e]),s=new this.constructor(n,this.stride);return s.setUsage(this.usage),s}onUpload(t){return this.onUploadCallback=t,this}toJSON(t){t.arrayBuffers===void 0&&(t.arrayBuffers={});let e=wm(this.array);t.arrayBuffers[e]===void 0&&(t.arrayBuffers[e]=Array.from(new Uint32Array(this.array.slice(0).buffer)));let n={uuid:this.uuid,buffer:e,type:this.array.constructor.name,stride:this.stride};return n.usage=this.usage,n}};function wm(i){return i.buffer._uuid===void 0&&(i.buffer._uuid=tr()),i.byteOffset===0&&i.byteLength===i.buffer.byteLength?i.buffer._uuid:i.buffer._uuid+":"+i.byteOffset+":"+i.byteLength}var Zn=new X,ya=class i{constructor(t,e,n,s=!1){this.isInterleavedBufferAttribute=!0,this.name="",this.data=t,this.itemSize=e,this.offset=n,this.normalized=s,this._normalizationScale=t!==void 0?Ih(t.array):void 0}get count(){return this.data.count}get array(){return this.data.array}set needsUpdate(t){this.data.needsUpdate=t}applyMatrix4(t){for(let e=0,n=this.data.count;e<n;e++)Zn.fromBufferAttribute(this,e),Zn.applyMatrix4(t),this.setXYZ(e,Zn.x,Zn.y,Zn.z);return this}applyNormalMatrix(t){for(let e=0,n=this.count;e<n;e++)Zn.fromBufferAttribute(this,e),Zn.applyNormalMatrix(t),this.setXYZ(e,Zn.x,Zn.y,Zn.z);return this}transformDirection(t){for(let e=0,n=this.count;e<n;e++)Zn.fromBufferAttribute(this,e),Zn.transformDirection(t),this.setXYZ(e,Zn.x,Zn.y,Zn.z);return this}getComponent(t,e){let n=this.array[t*this.data.stride+this.offset+e];return this.normalized&&(n=this._denormalize(n)),n}setComponent(t,e,n){return this.normalized&&(n=this._normalize(n)),this.data.array[t*this.data.stride+this.offset+e]=n,this}setX(t,e){return this.normalized&&(e=this._normalize(e)),this.data.array[t*this.data.stride+this.offset]=e,this}setY(t,e){return this.normalized&&(e=this._normalize(e)),this.data.array[t*this.data.stride+this.offset+1]=e,this}setZ(t,e){return this.normalized&&(e=this._normalize(e)),this.data.array[t*this.data.stride+this.offset+2]=e,this}setW(t,e){return this.normalized&&(e=this._normalize(e)),this.data.array[t*this.data.stride+this.offset+3]=e,this}getX(t){let e=this.data.array[t*this.data.stride+this.offset];return this.normalized&&(e=this._denormalize(e)),e}getY(t){let e=this.data.array[t*this.data.stride+this.offset+1];return this.normalized&&(e=this._denormalize(e)),e}getZ(t){let e=this.data.array[t*this.data.stride+this.offset+2];return this.normalized&&(e=this._denormalize(e)),e}getW(t){let e=this.data.array[t*this.data.stride+this.offset+3];return this.normalized&&(e=this._denormalize(e)),e}setXY(t,e,n){return t=t*this.data.stride+this.offset,this.normalized&&(e=this._normalize(e),n=this._normalize(n)),this.data.array[t+0]=e,this.data.array[t+1]=n,this}setXYZ(t,e,n,s){return t=t*this.data.stride+this.offset,this.normalized&&(e=this._normalize(e),n=this._normalize(n),s=this._normalize(s)),this.data.array[t+0]=e,this.data.array[t+1]=n,this.data.array[t+2]=s,this}setXYZW(t,e,n,s,r){return t=t*this.data.stride+this.offset,this.normalized&&(e=this._normalize(e),n=this._normalize(n),s=this._normalize(s),r=this._normalize(r)),this.data.array[t+0]=e,this.data.array[t+1]=n,this.data.array[t+2]=s,this.data.array[t+3]=r,this}clone(t){if(t===void 0){da("InterleavedBufferAttribute.clone(): Cloning an interleaved buffer attribute will de-interleave buffer data.");let e=[];for(let n=0;n<this.count;n++){let s=n*this.data.stride+this.offset;for(let r=0;r<this.itemSize;r++)e.push(this.data.array[s+r])}return new Fi(new this.array.constructor(e),this.itemSize,this.normalized)}else return t.interleavedBuffers===void 0&&(t.interleavedBuffers={}),t.interleavedBuffers[this.data.uuid]===void 0&&(t.interleavedBuffers[this.data.uuid]=this.data.clone(t)),new i(t.interleavedBuffers[this.data.uuid],this.itemSize,this.offset,this.normalized)}toJSON(t){if(t===void 0){da("InterleavedBufferAttribute.toJSON(): Serializing an interleaved buffer attribute will de-interleave buffer data.");let e=[];for(let n=0;n<this.count;n++){let s=n*this.data.stride+this.offset;for(let r=0;r<this.itemSize;r++)e.push(this.data.array[s+r])}return{itemSize:this.itemSize,type:this.array.constructor.name,array:e,normalized:this.normalized}}else return t.interleavedBuffers===void 0&&(t.interleavedBuffers={}),t.interleavedBuffers[this.data.uuid]===void 0&&(t.interleavedBuffers[this.data.uuid]=this.data.toJSON(t)),{isInterleavedBufferAttribute:!0,itemSize:this.itemSize,data:this.data.uuid,offset:this.offset,normalized:this.normalized}}_denormalize(t){let e=this._normalizationScale;return e!==void 0?Math.max(t/e,-1):Ff(t,this.data.array)}_normalize(t){let e=this._normalizationScale;return e!==void 0?Math.round(t*e):Of(t,this.data.array)}},qu=new X,Dv=new X,Nv=new oe,mi=class{constructor(t=new X(1,0,0),e=0){this.isPlane=!0,this.normal=t,this.constant=e}set(t,e){return this.normal.copy(t),this.constant=e,this}setComponents(t,e,n,s){return this.normal.set(t,e,n),this.constant=s,this}setFromNormalAndCoplanarPoint(t,e){return this.normal.copy(t),this.constant=-e.dot(this.normal),this}setFromCoplanarPoints(t,e,n){let s=qu.subVectors(n,e).cross(Dv.subVectors(t,e)).normalize();return this.setFromNormalAndCoplanarPoint(s,t),this}copy(t){return this.normal.copy(t.normal),this.constant=t.constant,this}normalize(){let t=1/this.normal.length();return this.normal.multiplyScalar(t),this.constant*=t,this}negate(){return this.constant*=-1,this.normal.negate(),this}distanceToPoint(t){return this.normal.dot(t)+this.constant}distanceToSphere(t){return this.distanceToPoint(t.center)-t.radius}projectPoint(t,e){return e.copy(t).addScaledVector(this.normal,-this.distanceToPoint(t))}intersectLine(t,e,n=!0){let s=t.delta(qu),r=this.normal.dot(s);if(r===0)return this.distanceToPoint(t.start)===0?e.copy(t.start):null;let o=-(t.start.dot(this.normal)+this.constant)/r;return n===!0&&(o<0||o>1)?null:e.copy(t.start).addScaledVector(s,o)}intersectsLine(t){let e=this.distanceToPoint(t.start),n=this.distanceToPoint(t.end);return e<0&&n>0||n<0&&e>0}intersectsBox(t){return t.intersectsPlane(this)}intersectsSphere(t){return t.intersectsPlane(this)}coplanarPoint(t){return t.copy(this.normal).multiplyScalar(-this.constant)}applyMatrix4(t,e){let n=e||Nv.getNormalMatrix(t),s=this.coplanarPoint(qu).applyMatrix4(t),r=this.normal.applyMatrix3(n).normalize();return this.constant=-s.dot(r),this}translate(t){return this.constant-=t.dot(this.normal),this}equals(t){return t.normal.equals(this.normal)&&t.constant===this.constant}clone(){return new this.constructor().copy(this)}toJSON(){return{normal:this.normal.toArray(),constant:this.constant}}fromJSON(t){return this.normal.fromArray(t.normal),this.constant=t.constant,this}},Uv=0,ns=class extends Oi{constructor(){super(),this.isMaterial=!0,Object.defineProperty(this,"id",{value:Uv++}),this.uuid=tr(),this.name="",this.type="Material",this.blending=wo,this.side=js,this.vertexColors=!1,this.opacity=1,this.transparent=!1,this.alphaHash=!1,this.blendSrc=uf,this.blendDst=ff,this.blendEquation=yr,this.blendSrcAlpha=null,this.blendDstAlpha=null,this.blendEquationAlpha=null,this.blendColor=new ue(0,0,0),this.blendAlpha=0,this.depthFunc=uo,this.depthTest=!0,this.depthWrite=!0,this.stencilWriteMask=255,this.stencilFunc=pg,this.stencilRef=0,this.stencilFuncMask=255,this.stencilFail=uc,this.stencilZFail=uc,this.stencilZPass=uc,this.stencilWrite=!1,this.clippingPlanes=null,this.clipIntersection=!1,this.clipShadows=!1,this.shadowSide=null,this.colorWrite=!0,this.precision=null,this.polygonOffset=!1,this.polygonOffsetFactor=0,this.polygonOffsetUnits=0,this.dithering=!1,this.alphaToCoverage=!1,this.premultipliedAlpha=!1,this.forceSinglePass=!1,this.allowOverride=!0,this.visible=!0,this.toneMapped=!0,this.userData={},this.version=0,this._alphaTest=0}get alphaTest(){return this._alphaTest}set alphaTest(t){this._alphaTest>0!=t>0&&this.version++,this._alphaTest=t}onBeforeRender(){}onBeforeCompile(){}customProgramCacheKey(){return this.onBeforeCompile.toString()}setValues(t){if(t!==void 0)for(let e in t){let n=t[e];if(n===void 0){jt(`Material: parameter '${e}' has value of undefined.`);continue}let s=this[e];if(s===void 0){jt(`Material: '${e}' is not a property of THREE.${this.type}.`);continue}s&&s.isColor?s.set(n):s&&s.isVector2&&n&&n.isVector2||s&&s.isEuler&&n&&n.isEuler||s&&s.isVector3&&n&&n.isVector3?s.copy(n):this[e]=n}}toJSON(t){let e=t===void 0||typeof t=="string";e&&(t={textures:{},images:{}});let n={metadata:{version:4.7,type:"Material",generator:"Material.toJSON"}};n.uuid=this.uuid,n.type=this.type,n.blending=this.blending,n.side=this.side,n.shadowSide=this.shadowSide,n.vertexColors=this.vertexColors,n.opacity=this.opacity,n.transparent=this.transparent,n.blendSrc=this.blendSrc,n.blendDst=this.blendDst,n.blendEquation=this.blendEquation,n.blendSrcAlpha=this.blendSrcAlpha,n.blendDstAlpha=this.blendDstAlpha,n.blendEquationAlpha=this.blendEquationAlpha,n.blendColor=this.blendColor.getHex(),n.blendAlpha=this.blendAlpha,n.depthFunc=this.depthFunc,n.depthTest=this.depthTest,n.depthWrite=this.depthWrite,n.colorWrite=this.colorWrite,n.clipIntersection=this.clipIntersection,n.clipShadows=this.clipShadows,n.stencilWriteMask=this.stencilWriteMask,n.stencilFunc=this.stencilFunc,n.stencilRef=this.stencilRef,n.stencilFuncMask=this.stencilFuncMask,n.stencilFail=this.stencilFail,n.stencilZFail=this.stencilZFail,n.stencilZPass=this.stencilZPass,n.stencilWrite=this.stencilWrite,n.polygonOffset=this.polygonOffset,n.polygonOffsetFactor=this.polygonOffsetFactor,n.polygonOffsetUnits=this.polygonOffsetUnits,n.dithering=this.dithering,n.alphaTest=this.alphaTest,n.alphaHash=this.alphaHash,n.alphaToCoverage=this.alphaToCoverage,n.premultipliedAlpha=this.premultipliedAlpha,n.forceSinglePass=this.forceSinglePass,n.allowOverride=this.allowOverride,n.visible=this.visible,n.toneMapped=this.toneMapped,n.name=this.name,this.color&&this.color.isColor&&(n.color=this.color.getHex()),this.roughness!==void 0&&(n.roughness=this.roughness),this.metalness!==void 0&&(n.metalness=this.metalness),this.sheen!==void 0&&(n.sheen=this.sheen),this.sheenColor&&this.sheenColor.isColor&&(n.sheenColor=this.sheenColor.getHex()),this.sheenRoughness!==void 0&&(n.sheenRoughness=this.sheenRoughness),this.emissive&&this.emissive.isColor&&(n.emissive=this.emissive.getHex()),this.emissiveIntensity!==void 0&&(n.emissiveIntensity=this.emissiveIntensity),this.specular&&this.specular.isColor&&(n.specular=this.specular.getHex()),this.specularIntensity!==void 0&&(n.specularIntensity=this.specularIntensity),this.specularColor&&this.specularColor.isColor&&(n.specularColor=this.specularColor.getHex()),this.shininess!==void 0&&(n.shininess=this.shininess),this.clearcoat!==void 0&&(n.clearcoat=this.clearcoat),this.clearcoatRoughness!==void 0&&(n.clearcoatRoughness=this.clearcoatRoughness),this.diffuseRoughness!==void 0&&(n.diffuseRoughness=this.diffuseRoughness),this.diffuseRoughnessMap&&this.diffuseRoughnessMap.isTexture&&(n.diffuseRoughnessMap=this.diffuseRoughnessMap.toJSON(t).uuid),this.clearcoatMap&&this.clearcoatMap.isTexture&&(n.clearcoatMap=this.clearcoatMap.toJSON(t).uuid),this.clearcoatRoughnessMap&&this.clearcoatRoughnessMap.isTexture&&(n.clearcoatRoughnessMap=this.clearcoatRoughnessMap.toJSON(t).uuid),this.clearcoatNormalMap&&this.clearcoatNormalMap.isTexture&&(n.clearcoatNormalMap=this.clearcoatNormalMap.toJSON(t).uuid,n.clearcoatNormalScale=this.clearcoatNormalScale.toArray()),this.sheenColorMap&&this.sheenColorMap.isTexture&&(n.sheenColorMap=this.sheenColorMap.toJSON(t).uuid),this.sheenRoughnessMap&&this.sheenRoughnessMap.isTexture&&(n.sheenRoughnessMap=this.sheenRoughnessMap.toJSON(t).uuid),this.dispersion!==void 0&&(n.dispersion=this.dispersion),this.retroreflectivity!==void 0&&(n.retroreflectivity=this.retroreflectivity),this.iridescence!==void 0&&(n.iridescence=this.iridescence),this.iridescenceIOR!==void 0&&(n.iridescenceIOR=this.iridescenceIOR),this.iridescenceThicknessMinimum!==void 0&&(n.iridescenceThicknessMinimum=this.iridescenceThicknessMinimum),this.iridescenceThicknessMaximum!==void 0&&(n.iridescenceThicknessMaximum=this.iridescenceThicknessMaximum),this.iridescenceMap&&this.iridescenceMap.isTexture&&(n.iridescenceMap=this.iridescenceMap.toJSON(t).uuid),this.iridescenceThicknessMap&&this.iridescenceThicknessMap.isTexture&&(n.iridescenceThicknessMap=this.iridescenceThicknessMap.toJSON(t).uuid),this.anisotropy!==void 0&&(n.anisotropy=this.anisotropy),this.anisotropyRotation!==void 0&&(n.anisotropyRotation=this.anisotropyRotation),this.anisotropyMap&&this.anisotropyMap.isTexture&&(n.anisotropyMap=this.anisotropyMap.toJSON(t).uuid),this.map&&this.map.isTexture&&(n.map=this.map.toJSON(t).uuid),this.matcap&&this.matcap.isTexture&&(n.matcap=this.matcap.toJSON(t).uuid),this.alphaMap&&this.alphaMap.isTexture&&(n.alphaMap=this.alphaMap.toJSON(t).uuid),this.lightMap&&this.lightMap.isTexture&&(n.lightMap=this.lightMap.toJSON(t).uuid,n.lightMapIntensity=this.lightMapIntensity),this.aoMap&&this.aoMap.isTexture&&(n.aoMap=this.aoMap.toJSON(t).uuid,n.aoMapIntensity=this.aoMapIntensity),this.bumpMap&&this.bumpMap.isTexture&&(n.bumpMap=this.bumpMap.toJSON(t).uuid,n.bumpScale=this.bumpScale),this.normalMap&&this.normalMap.isTexture&&(n.normalMap=this.normalMap.toJSON(t).uuid,n.normalMapType=this.normalMapType,n.normalScale=this.normalScale.toArray()),this.displacementMap&&this.displacementMap.isTexture&&(n.displacementMap=this.displacementMap.toJSON(t).uuid,n.displacementScale=this.displacementScale,n.displacementBias=this.displacementBias),this.roughnessMap&&this.roughnessMap.isTexture&&(n.roughnessMap=this.roughnessMap.toJSON(t).uuid),this.metalnessMap&&this.metalnessMap.isTexture&&(n.metalnessMap=this.metalnessMap.toJSON(t).uuid),this.emissiveMap&&this.emissiveMap.isTexture&&(n.emissiveMap=this.emissiveMap.toJSON(t).uuid),this.specularMap&&this.specularMap.isTexture&&(n.specularMap=this.specularMap.toJSON(t).uuid),this.specularIntensityMap&&this.specularIntensityMap.isTexture&&(n.specularIntensityMap=this.specularIntensityMap.toJSON(t).uuid),this.specularColorMap&&this.specularColorMap.isTexture&&(n.specularColorMap=this.specularColorMap.toJSON(t).uuid),this.envMap&&this.envMap.isTexture&&(n.envMap=this.envMap.toJSON(t).uuid,this.combine!==void 0&&(n.combine=this.combine)),this.envMapRotation!==void 0&&(n.envMapRotation=this.envMapRotation.toArray()),this.envMapIntensity!==void 0&&(n.envMapIntensity=this.envMapIntensity),this.reflectivity!==void 0&&(n.reflectivity=this.reflectivity),this.refractionRatio!==void 0&&(n.refractionRatio=this.refractionRatio),this.gradientMap&&this.gradientMap.isTexture&&(n.gradientMap=this.gradientMap.toJSON(t).uuid),this.transmission!==void 0&&(n.transmission=this.transmission),this.transmissionMap&&this.transmissionMap.isTexture&&(n.transmissionMap=this.transmissionMap.toJSON(t).uuid),this.thickness!==void 0&&(n.thickness=this.thickness),this.thicknessMap&&this.thicknessMap.isTexture&&(n.thicknessMap=this.thicknessMap.toJSON(t).uuid),this.attenuationDistance!==void 0&&(n.attenuationDistance=this.attenuationDistance),this.attenuationColor!==void 0&&(n.attenuationColor=this.attenuationColor.getHex()),this.size!==void 0&&(n.size=this.size),this.sizeAttenuation!==void 0&&(n.sizeAttenuation=this.sizeAttenuation),Array.isArray(this.clippingPlanes)&&this.clippingPlanes.length>0&&(n.clippingPlanes=this.clippingPlanes.map(r=>r.toJSON())),this.rotation!==void 0&&(n.rotation=this.rotation),this.depthPacking!==void 0&&(n.depthPacking=this.depthPacking),this.linewidth!==void 0&&(n.linewidth=this.linewidth),this.linecap!==void 0&&(n.linecap=this.linecap),this.linejoin!==void 0&&(n.linejoin=this.linejoin),this.dashSize!==void 0&&(n.dashSize=this.dashSize),this.gapSize!==void 0&&(n.gapSize=this.gapSize),this.scale!==void 0&&(n.scale=this.scale),this.wireframe!==void 0&&(n.wireframe=this.wireframe),this.wireframeLinewidth!==void 0&&(n.wireframeLinewidth=this.wireframeLinewidth),this.wireframeLinecap!==void 0&&(n.wireframeLinecap=this.wireframeLinecap),this.wireframeLinejoin!==void 0&&(n.wireframeLinejoin=this.wireframeLinejoin),this.flatShading!==void 0&&(n.flatShading=this.flatShading),this.fog!==void 0&&(n.fog=this.fog),Object.keys(this.userData).length>0&&(n.userData=this.userData);function s(r){let o=[];for(let a in r){let l=r[a];delete l.metadata,o.push(l)}return o}if(e){let r=s(t.textures),o=s(t.images);r.length>0&&(n.textures=r),o.length>0&&(n.images=o)}return n}fromJSON(t,e){if(t.uuid!==void 0&&(this.uuid=t.uuid),t.name!==void 0&&(this.name=t.name),t.color!==void 0&&this.color!==void 0&&this.color.setHex(t.color),t.roughness!==void 0&&(this.roughness=t.roughness),t.metalness!==void 0&&(this.metalness=t.metalness),t.sheen!==void 0&&(this.sheen=t.sheen),t.sheenColor!==void 0&&(this.sheenColor=new ue().setHex(t.sheenColor)),t.sheenRoughness!==void 0&&(this.sheenRoughness=t.sheenRoughness),t.emissive!==void 0&&this.emissive!==void 0&&this.emissive.setHex(t.emissive),t.specular!==void 0&&this.specular!==void 0&&this.specular.setHex(t.specular),t.specularIntensity!==void 0&&(this.specularIntensity=t.specularIntensity),t.specularColor!==void 0&&this.specularColor!==void 0&&this.specularColor.setHex(t.specularColor),t.shininess!==void 0&&(this.shininess=t.shininess),t.clearcoat!==void 0&&(this.clearcoat=t.clearcoat),t.clearcoatRoughness!==void 0&&(this.clearcoatRoughness=t.clearcoatRoughness),t.diffuseRoughness!==void 0&&(this.diffuseRoughness=t.diffuseRoughness),t.dispersion!==void 0&&(this.dispersion=t.dispersion),t.retroreflectivity!==void 0&&(this.retroreflectivity=t.retroreflectivity),t.iridescence!==void 0&&(this.iridescence=t.iridescence),t.iridescenceIOR!==void 0&&(this.iridescenceIOR=t.iridescenceIOR),t.iridescenceThicknessMinimum!==void 0&&(this.iridescenceThicknessMinimum=t.iridescenceThicknessMinimum),t.iridescenceThicknessMaximum!==void 0&&(this.iridescenceThicknessMaximum=t.iridescenceThicknessMaximum),t.iridescenceThicknessRange!==void 0&&(this.iridescenceThicknessMinimum=t.iridescenceThicknessRange[0],this.iridescenceThicknessMaximum=t.iridescenceThicknessRange[1]),t.transmission!==void 0&&(this.transmission=t.transmission),t.thickness!==void 0&&(this.thickness=t.thickness),t.attenuationDistance!==void 0&&(this.attenuationDistance=t.attenuationDistance),t.attenuationColor!==void 0&&this.attenuationColor!==void 0&&this.attenuationColor.setHex(t.attenuationColor),t.anisotropy!==void 0&&(this.anisotropy=t.anisotropy),t.anisotropyRotation!==void 0&&(this.anisotropyRotation=t.anisotropyRotation),t.fog!==void 0&&(this.fog=t.fog),t.flatShading!==void 0&&(this.flatShading=t.flatShading),t.blending!==void 0&&(this.blending=t.blending),t.combine!==void 0&&(this.combine=t.combine),t.side!==void 0&&(this.side=t.side),t.shadowSide!==void 0&&(this.shadowSide=t.shadowSide),t.opacity!==void 0&&(this.opacity=t.opacity),t.transparent!==void 0&&(this.transparent=t.transparent),t.alphaTest!==void 0&&(this.alphaTest=t.alphaTest),t.alphaHash!==void 0&&(this.alphaHash=t.alphaHash),t.depthFunc!==void 0&&(this.depthFunc=t.depthFunc),t.depthTest!==void 0&&(this.depthTest=t.depthTest),t.depthWrite!==void 0&&(this.depthWrite=t.depthWrite),t.colorWrite!==void 0&&(this.colorWrite=t.colorWrite),t.clippingPlanes!==void 0&&(this.clippingPlanes=t.clippingPlanes.map(n=>new mi().fromJSON(n))),t.clipIntersection!==void 0&&(this.clipIntersection=t.clipIntersection),t.clipShadows!==void 0&&(this.clipShadows=t.clipShadows),t.depthPacking!==void 0&&(this.depthPacking=t.depthPacking),t.blendSrc!==void 0&&(this.blendSrc=t.blendSrc),t.blendDst!==void 0&&(this.blendDst=t.blendDst),t.blendEquation!==void 0&&(this.blendEquation=t.blendEquation),t.blendSrcAlpha!==void 0&&(this.blendSrcAlpha=t.blendSrcAlpha),t.blendDstAlpha!==void 0&&(this.blendDstAlpha=t.blendDstAlpha),t.blendEquationAlpha!==void 0&&(this.blendEquationAlpha=t.blendEquationAlpha),t.blendColor!==void 0&&this.blendColor!==void 0&&this.blendColor.setHex(t.blendColor),t.blendAlpha!==void 0&&(this.blendAlpha=t.blendAlpha),t.stencilWriteMask!==void 0&&(this.stencilWriteMask=t.stencilWriteMask),t.stencilFunc!==void 0&&(this.stencilFunc=t.stencilFunc),t.stencilRef!==void 0&&(this.stencilRef=t.stencilRef),t.stencilFuncMask!==void 0&&(this.stencilFuncMask=t.stencilFuncMask),t.stencilFail!==void 0&&(this.stencilFail=t.stencilFail),t.stencilZFail!==void 0&&(this.stencilZFail=t.stencilZFail),t.stencilZPass!==void 0&&(this.stencilZPass=t.stencilZPass),t.stencilWrite!==void 0&&(this.stencilWrite=t.stencilWrite),t.wireframe!==void 0&&(this.wireframe=t.wireframe),t.wireframeLinewidth!==void 0&&(this.wireframeLinewidth=t.wireframeLinewidth),t.wireframeLinecap!==void 0&&(this.wireframeLinecap=t.wireframeLinecap),t.wireframeLinejoin!==void 0&&(this.wireframeLinejoin=t.wireframeLinejoin),t.rotation!==void 0&&(this.rotation=t.rotation),t.linewidth!==void 0&&(this.linewidth=t.linewidth),t.linecap!==void 0&&(this.linecap=t.linecap),t.linejoin!==void 0&&(this.linejoin=t.linejoin),t.dashSize!==void 0&&(this.dashSize=t.dashSize),t.gapSize!==void 0&&(this.gapSize=t.gapSize),t.scale!==void 0&&(this.scale=t.scale),t.polygonOffset!==void 0&&(this.polygonOffset=t.polygonOffset),t.polygonOffsetFactor!==void 0&&(this.polygonOffsetFactor=t.polygonOffsetFactor),t.polygonOffsetUnits!==void 0&&(this.polygonOffsetUnits=t.polygonOffsetUnits),t.dithering!==void 0&&(this.dithering=t.dithering),t.alphaToCoverage!==void 0&&(this.alphaToCoverage=t.alphaToCoverage),t.premultipliedAlpha!==void 0&&(this.premultipliedAlpha=t.premultipliedAlpha),t.forceSinglePass!==void 0&&(this.forceSinglePass=t.forceSinglePass),t.allowOverride!==void 0&&(this.allowOverride=t.allowOverride),t.visible!==void 0&&(this.visible=t.visible),t.toneMapped!==void 0&&(this.toneMapped=t.toneMapped),t.userData!==void 0&&(this.userData=t.userData),t.vertexColors!==void 0&&(typeof t.vertexColors=="number"?this.vertexColors=t.vertexColors>0:this.vertexColors=t.vertexColors),t.size!==void 0&&(this.size=t.size),t.sizeAttenuation!==void 0&&(this.sizeAttenuation=t.sizeAttenuation),t.map!==void 0&&(this.map=e[t.map]||null),t.matcap!==void 0&&(this.matcap=e[t.matcap]||null),t.alphaMap!==void 0&&(this.alphaMap=e[t.alphaMap]||null),t.bumpMap!==void 0&&(this.bumpMap=e[t.bumpMap]||null),t.bumpScale!==void 0&&(this.bumpScale=t.bumpScale),t.normalMap!==void 0&&(this.normalMap=e[t.normalMap]||null),t.normalMapType!==void 0&&(this.normalMapType=t.normalMapType),t.normalScale!==void 0){let n=t.normalScale;Array.isArray(n)===!1&&(n=[n,n]),this.normalScale=new Jt().fromArray(n)}return t.displacementMap!==void 0&&(this.displacementMap=e[t.displacementMap]||null),t.displacementScale!==void 0&&(this.displacementScale=t.displacementScale),t.displacementBias!==void 0&&(this.displacementBias=t.displacementBias),t.roughnessMap!==void 0&&(this.roughnessMap=e[t.roughnessMap]||null),t.metalnessMap!==void 0&&(this.metalnessMap=e[t.metalnessMap]||null),t.emissiveMap!==void 0&&(this.emissiveMap=e[t.emissiveMap]||null),t.emissiveIntensity!==void 0&&(this.emissiveIntensity=t.emissiveIntensity),t.specularMap!==void 0&&(this.specularMap=e[t.specularMap]||null),t.specularIntensityMap!==void 0&&(this.specularIntensityMap=e[t.specularIntensityMap]||null),t.specularColorMap!==void 0&&(this.specularColorMap=e[t.specularColorMap]||null),t.envMap!==void 0&&(this.envMap=e[t.envMap]||null),t.envMapRotation!==void 0&&this.envMapRotation.fromArray(t.envMapRotation),t.envMapIntensity!==void 0&&(this.envMapIntensity=t.envMapIntensity),t.reflectivity!==void 0&&(this.reflectivity=t.reflectivity),t.refractionRatio!==void 0&&(this.refractionRatio=t.refractionRatio),t.lightMap!==void 0&&(this.lightMap=e[t.lightMap]||null),t.lightMapIntensity!==void 0&&(this.lightMapIntensity=t.lightMapIntensity),t.aoMap!==void 0&&(this.aoMap=e[t.aoMap]||null),t.aoMapIntensity!==void 0&&(this.aoMapIntensity=t.aoMapIntensity),t.gradientMap!==void 0&&(this.gradientMap=e[t.gradientMap]||null),t.clearcoatMap!==void 0&&(this.clearcoatMap=e[t.clearcoatMap]||null),t.clearcoatRoughnessMap!==void 0&&(this.clearcoatRoughnessMap=e[t.clearcoatRoughnessMap]||null),t.clearcoatNormalMap!==void 0&&(this.clearcoatNormalMap=e[t.clearcoatNormalMap]||null),t.clearcoatNormalScale!==void 0&&(this.clearcoatNormalScale=new Jt().fromArray(t.clearcoatNormalScale)),t.diffuseRoughnessMap!==void 0&&(this.diffuseRoughnessMap=e[t.diffuseRoughnessMap]||null),t.iridescenceMap!==void 0&&(this.iridescenceMap=e[t.iridescenceMap]||null),t.iridescenceThicknessMap!==void 0&&(this.iridescenceThicknessMap=e[t.iridescenceThicknessMap]||null),t.transmissionMap!==void 0&&(this.transmissionMap=e[t.transmissionMap]||null),t.thicknessMap!==void 0&&(this.thicknessMap=e[t.thicknessMap]||null),t.anisotropyMap!==void 0&&(this.anisotropyMap=e[t.anisotropyMap]||null),t.sheenColorMap!==void 0&&(this.sheenColorMap=e[t.sheenColorMap]||null),t.sheenRoughnessMap!==void 0&&(this.sheenRoughnessMap=e[t.sheenRoughnessMap]||null),this}clone(){return new this.constructor().copy(this)}copy(t){this.name=t.name,this.blending=t.blending,this.side=t.side,this.vertexColors=t.vertexColors,this.opacity=t.opacity,this.transparent=t.transparent,this.blendSrc=t.blendSrc,this.blendDst=t.blendDst,this.blendEquation=t.blendEquation,this.blendSrcAlpha=t.blendSrcAlpha,this.blendDstAlpha=t.blendDstAlpha,this.blendEquationAlpha=t.blendEquationAlpha,this.blendColor.copy(t.blendColor),this.blendAlpha=t.blendAlpha,this.depthFunc=t.depthFunc,this.depthTest=t.depthTest,this.depthWrite=t.depthWrite,this.stencilWriteMask=t.stencilWriteMask,this.stencilFunc=t.stencilFunc,this.stencilRef=t.stencilRef,this.stencilFuncMask=t.stencilFuncMask,this.stencilFail=t.stencilFail,this.stencilZFail=t.stencilZFail,this.stencilZPass=t.stencilZPass,this.stencilWrite=t.stencilWrite;let e=t.clippingPlanes,n=null;if(e!==null){let s=e.length;n=new Array(s);for(let r=0;r!==s;++r)n[r]=e[r].clone()}return this.clippingPlanes=n,this.clipIntersection=t.clipIntersection,this.clipShadows=t.clipShadows,this.shadowSide=t.shadowSide,this.colorWrite=t.colorWrite,this.precision=t.precision,this.polygonOffset=t.polygonOffset,this.polygonOffsetFactor=t.polygonOffsetFactor,this.polygonOffsetUnits=t.polygonOffsetUnits,this.dithering=t.dithering,this.alphaTest=t.alphaTest,this.alphaHash=t.alphaHash,this.alphaToCoverage=t.alphaToCoverage,this.premultipliedAlpha=t.premultipliedAlpha,this.forceSinglePass=t.forceSinglePass,this.allowOverride=t.allowOverride,this.visible=t.visible,this.toneMapped=t.toneMapped,this.userData=JSON.parse(JSON.stringify(t.userData)),this}dispose(){this.dispatchEvent({type:"dispose"})}set needsUpdate(t){t===!0&&this.version++}},xo=class extends ns{constructor(t){super(),this.isSpriteMaterial=!0,this.type="SpriteMaterial",this.color=new ue(16777215),this.map=null,this.alphaMap=null,this.rotation=0,this.sizeAttenuation=!0,this.transparent=!0,this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.color.copy(t.color),this.map=t.map,this.alphaMap=t.alphaMap,this.rotation=t.rotation,this.sizeAttenuation=t.sizeAttenuation,this.fog=t.fog,this}},no,ia=new X,io=new X,so=new X,ro=new Jt,sa=new Jt,Tg=new De,Hl=new X,ra=new X,Wl=new X,Tm=new Jt,$u=new Jt,Em=new Jt,va=class extends Fn{constructor(t=new xo){if(super(),this.isSprite=!0,this.type="Sprite",no===void 0){no=new an;let e=new Float32Array([-.5,-.5,0,0,0,.5,-.5,0,1,0,.5,.5,0,1,1,-.5,.5,0,0,1]),n=new Tc(e,5);no.setIndex([0,1,2,0,2,3]),no.setAttribute("position",new ya(n,3,0,!1)),no.setAttribute("uv",new ya(n,2,3,!1))}this.geometry=no,this.material=t,this.center=new Jt(.5,.5),this.count=1}intersectsFrustum(t){return t.intersectsSprite(this)}raycast(t,e){t.camera===null&&se('Sprite: "Raycaster.camera" needs to be set in order to raycast against sprites.'),io.setFromMatrixScale(this.matrixWorld),Tg.copy(t.camera.matrixWorld),this.modelViewMatrix.multiplyMatrices(t.camera.matrixWorldInverse,this.matrixWorld),so.setFromMatrixPosition(this.modelViewMatrix),t.camera.isPerspectiveCamera&&this.material.sizeAttenuation===!1&&io.multiplyScalar(-so.z);let n=this.material.rotation,s,r;n!==0&&(r=Math.cos(n),s=Math.sin(n));let o=this.center;Xl(Hl.set(-.5,-.5,0),so,o,io,s,r),Xl(ra.set(.5,-.5,0),so,o,io,s,r),Xl(Wl.set(.5,.5,0),so,o,io,s,r),Tm.set(0,0),$u.set(1,0),Em.set(1,1);let a=t.ray.intersectTriangle(Hl,ra,Wl,!1,ia);if(a===null&&(Xl(ra.set(-.5,.5,0),so,o,io,s,r),$u.set(0,1),a=t.ray.intersectTriangle(Hl,Wl,ra,!1,ia),a===null))return;let l=t.ray.origin.distanceTo(ia);l<t.near||l>t.far||e.push({distance:l,point:ia.clone(),uv:ts.getInterpolation(ia,Hl,ra,Wl,Tm,$u,Em,new Jt),face:null,object:this})}copy(t,e){return super.copy(t,e),t.center!==void 0&&this.center.copy(t.center),this.material=t.material,this}toJSON(t){let e=super.toJSON(t);return e.object.center=this.center.toArray(),e}};function Xl(i,t,e,n,s,r){ro.subVectors(i,e).addScalar(.5).multiply(n),s!==void 0?(sa.x=r*ro.x-s*ro.y,sa.y=s*ro.x+r*ro.y):sa.copy(ro),i.copy(t),i.x+=sa.x,i.y+=sa.y,i.applyMatrix4(Tg)}var Ss=new X,Yu=new X,ql=new X,$l=new X,mr=class{constructor(t=new X,e=new X(0,0,-1)){this.origin=t,this.direction=e}set(t,e){return this.origin.copy(t),this.direction.copy(e),this}copy(t){return this.origin.copy(t.origin),this.direction.copy(t.direction),this}at(t,e){return e.copy(this.origin).addScaledVector(this.direction,t)}lookAt(t){return this.direction.copy(t).sub(this.origin).normalize(),this}recast(t){return this.origin.copy(this.at(t,Ss)),this}closestPointToPoint(t,e){e.subVectors(t,this.origin);let n=e.dot(this.direction);return n<0?e.copy(this.origin):e.copy(this.origin).addScaledVector(this.direction,n)}distanceToPoint(t){return Math.sqrt(this.distanceSqToPoint(t))}distanceSqToPoint(t){let e=Ss.subVectors(t,this.origin).dot(this.direction);return e<0?this.origin.distanceToSquared(t):(Ss.copy(this.origin).addScaledVector(this.direction,e),Ss.distanceToSquared(t))}distanceSqToSegment(t,e,n,s){Yu.copy(t).add(e).multiplyScalar(.5),ql.copy(e).sub(t).normalize(),$l.copy(this.origin).sub(Yu);let r=t.distanceTo(e)*.5,o=-this.direction.dot(ql),a=$l.dot(this.direction),l=-$l.dot(ql),c=$l.lengthSq(),f=Math.abs(1-o*o),u,h,d,p;if(f>0)if(u=o*l-a,h=o*a-l,p=r*f,u>=0)if(h>=-p)if(h<=p){let _=1/f;u*=_,h*=_,d=u*(u+o*h+2*a)+h*(o*u+h+2*l)+c}else h=r,u=Math.max(0,-(o*h+a)),d=-u*u+h*(h+2*l)+c;else h=-r,u=Math.max(0,-(o*h+a)),d=-u*u+h*(h+2*l)+c;else h<=-p?(u=Math.max(0,-(-o*r+a)),h=u>0?-r:Math.min(Math.max(-r,-l),r),d=-u*u+h*(h+2*l)+c):h<=p?(u=0,h=Math.min(Math.max(-r,-l),r),d=h*(h+2*l)+c):(u=Math.max(0,-(o*r+a)),h=u>0?r:Math.min(Math.max(-r,-l),r),d=-u*u+h*(h+2*l)+c);else h=o>0?-r:r,u=Math.max(0,-(o*h+a)),d=-u*u+h*(h+2*l)+c;return n&&n.copy(this.origin).addScaledVector(this.direction,u),s&&s.copy(Yu).addScaledVector(ql,h),d}intersectSphere(t,e){if(t.radius<0)return null;Ss.subVectors(t.center,this.origin);let n=Ss.dot(this.direction),s=Ss.dot(Ss)-n*n,r=t.radius*t.radius;if(s>r)return null;let o=Math.sqrt(r-s),a=n-o,l=n+o;return l<0?null:a<0?this.at(l,e):this.at(a,e)}intersectsSphere(t){return t.radius<0?!1:this.distanceSqToPoint(t.center)<=t.radius*t.radius}distanceToPlane(t){let e=t.normal.dot(this.direction);if(e===0)return t.distanceToPoint(this.origin)===0?0:null;let n=-(this.origin.dot(t.normal)+t.constant)/e;return n>=0?n:null}intersectPlane(t,e){let n=this.distanceToPlane(t);return n===null?null:this.at(n,e)}intersectsPlane(t){let e=t.distanceToPoint(this.origin);return e===0||t.normal.dot(this.direction)*e<0}intersectBox(t,e){let n,s,r,o,a,l,c=1/this.direction.x,f=1/this.direction.y,u=1/this.direction.z,h=this.origin;return c>=0?(n=(t.min.x-h.x)*c,s=(t.max.x-h.x)*c):(n=(t.max.x-h.x)*c,s=(t.min.x-h.x)*c),f>=0?(r=(t.min.y-h.y)*f,o=(t.max.y-h.y)*f):(r=(t.max.y-h.y)*f,o=(t.min.y-h.y)*f),n>o||r>s||((r>n||isNaN(n))&&(n=r),(o<s||isNaN(s))&&(s=o),u>=0?(a=(t.min.z-h.z)*u,l=(t.max.z-h.z)*u):(a=(t.max.z-h.z)*u,l=(t.min.z-h.z)*u),n>l||a>s)||((a>n||n!==n)&&(n=a),(l<s||s!==s)&&(s=l),s<0)?null:this.at(n>=0?n:s,e)}intersectsBox(t){return this.intersectBox(t,Ss)!==null}intersectTriangle(t,e,n,s,r){let o=this.origin,a=this.direction,l=a.x,c=a.y,f=a.z,u=t.x-o.x,h=t.y-o.y,d=t.z-o.z,p=e.x-o.x,_=e.y-o.y,g=e.z-o.z,m=n.x-o.x,v=n.y-o.y,A=n.z-o.z,S=Math.abs(l),R=Math.abs(c),E=Math.abs(f),x,T,U,N,L,z,O,P,G,q,H,ct;if(S>=R&&S>=E?(U=l,z=u,G=p,ct=m,l>=0?(x=c,T=f,N=h,L=d,O=_,P=g,q=v,H=A):(x=f,T=c,N=d,L=h,O=g,P=_,q=A,H=v)):R>=E?(U=c,z=h,G=_,ct=v,c>=0?(x=f,T=l,N=d,L=u,O=g,P=p,q=A,H=m):(x=l,T=f,N=u,L=d,O=p,P=g,q=m,H=A)):(U=f,z=d,G=g,ct=A,f>=0?(x=l,T=c,N=u,L=h,O=p,P=_,q=m,H=v):(x=c,T=l,N=h,L=u,O=_,P=p,q=v,H=m)),U===0)return null;let K=x/U,et=T/U,st=1/U,pt=N-K*z,dt=L-et*z,Q=O-K*G,_t=P-et*G,vt=q-K*ct,Pt=H-et*ct,Tt=vt*_t-Pt*Q,Yt=pt*Pt-dt*vt,ce=Q*dt-_t*pt;if(s){if(Tt<0||Yt<0||ce<0)return null}else if((Tt<0||Yt<0||ce<0)&&(Tt>0||Yt>0||ce>0))return null;let Xt=Tt+Yt+ce;if(Xt===0)return null;let ge=st*(Tt*z+Yt*G+ce*ct);return(Xt>0?ge<0:ge>0)?null:this.at(ge/Xt,r)}applyMatrix4(t){return this.origin.applyMatrix4(t),this.direction.transformDirection(t),this}equals(t){return t.origin.equals(this.origin)&&t.direction.equals(this.direction)}clone(){return new this.constructor().copy(this)}},is=class extends ns{constructor(t){super(),this.isMeshBasicMaterial=!0,this.type="MeshBasicMaterial",this.color=new ue(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new ws,this.combine=df,this.reflectivity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.color.copy(t.color),this.map=t.map,this.lightMap=t.lightMap,this.lightMapIntensity=t.lightMapIntensity,this.aoMap=t.aoMap,this.aoMapIntensity=t.aoMapIntensity,this.specularMap=t.specularMap,this.alphaMap=t.alphaMap,this.envMap=t.envMap,this.envMapRotation.copy(t.envMapRotation),this.combine=t.combine,this.reflectivity=t.reflectivity,this.refractionRatio=t.refractionRatio,this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this.wireframeLinecap=t.wireframeLinecap,this.wireframeLinejoin=t.wireframeLinejoin,this.fog=t.fog,this}},Am=new De,fr=new mr,Yl=new pr,Cm=new X,Zl=new X,Jl=new X,Kl=new X,Zu=new X,jl=new X,Rm=new X,Ql=new X,bn=class extends Fn{constructor(t=new an,e=new is){super(),this.isMesh=!0,this.type="Mesh",this.geometry=t,this.material=e,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.count=1,this.updateMorphTargets()}copy(t,e){return super.copy(t,e),t.morphTargetInfluences!==void 0?this.morphTargetInfluences=t.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,t.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},t.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(t.material)?t.material.slice():t.material,this.geometry=t.geometry,this}updateMorphTargets(){let e=this.geometry.morphAttributes,n=Object.keys(e);if(n.length>0){let s=e[n[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}getVertexPosition(t,e){let n=this.geometry,s=n.attributes.position,r=n.morphAttributes.position,o=n.morphTargetsRelative;e.fromBufferAttribute(s,t);let a=this.morphTargetInfluences;if(r&&a){jl.set(0,0,0);for(let l=0,c=r.length;l<c;l++){let f=a[l],u=r[l];f!==0&&(Zu.fromBufferAttribute(u,t),o?jl.addScaledVector(Zu,f):jl.addScaledVector(Zu.sub(e),f))}e.add(jl)}return e}intersectsFrustum(t){return t.intersectsObject(this)}raycast(t,e){let n=this.geometry,s=this.material,r=this.matrixWorld;s!==void 0&&(n.boundingSphere===null&&n.computeBoundingSphere(),Yl.copy(n.boundingSphere),Yl.applyMatrix4(r),fr.copy(t.ray).recast(t.near),!(Yl.containsPoint(fr.origin)===!1&&(fr.intersectSphere(Yl,Cm)===null||fr.origin.distanceToSquared(Cm)>(t.far-t.near)**2))&&(Am.copy(r).invert(),fr.copy(t.ray).applyMatrix4(Am),!(n.boundingBox!==null&&fr.intersectsBox(n.boundingBox)===!1)&&this._computeIntersections(t,e,fr)))}_computeIntersections(t,e,n){let s,r=this.geometry,o=this.material,a=r.index,l=r.attributes.position,c=r.attributes.uv,f=r.attributes.uv1,u=r.attributes.normal,h=r.groups,d=r.drawRange;if(a!==null)if(Array.isArray(o))for(let p=0,_=h.length;p<_;p++){let g=h[p],m=o[g.materialIndex],v=Math.max(g.start,d.start),A=Math.min(a.count,Math.min(g.start+g.count,d.start+d.count));for(let S=v,R=A;S<R;S+=3){let E=a.getX(S),x=a.getX(S+1),T=a.getX(S+2);s=tc(this,m,t,n,c,f,u,E,x,T),s&&(s.faceIndex=Math.floor(S/3),s.face.materialIndex=g.materialIndex,e.push(s))}}else{let p=Math.max(0,d.start),_=Math.min(a.count,d.start+d.count);for(let g=p,m=_;g<m;g+=3){let v=a.getX(g),A=a.getX(g+1),S=a.getX(g+2);s=tc(this,o,t,n,c,f,u,v,A,S),s&&(s.faceIndex=Math.floor(g/3),e.push(s))}}else if(l!==void 0)if(Array.isArray(o))for(let p=0,_=h.length;p<_;p++){let g=h[p],m=o[g.materialIndex],v=Math.max(g.start,d.start),A=Math.min(l.count,Math.min(g.start+g.count,d.start+d.count));for(let S=v,R=A;S<R;S+=3){let E=S,x=S+1,T=S+2;s=tc(this,m,t,n,c,f,u,E,x,T),s&&(s.faceIndex=Math.floor(S/3),s.face.materialIndex=g.materialIndex,e.push(s))}}else{let p=Math.max(0,d.start),_=Math.min(l.count,d.start+d.count);for(let g=p,m=_;g<m;g+=3){let v=g,A=g+1,S=g+2;s=tc(this,o,t,n,c,f,u,v,A,S),s&&(s.faceIndex=Math.floor(g/3),e.push(s))}}}};function Fv(i,t,e,n,s,r,o,a){let l;if(t.side===ei?l=n.intersectTriangle(o,r,s,!0,a):l=n.intersectTriangle(s,r,o,t.side===js,a),l===null)return null;Ql.copy(a),Ql.applyMatrix4(i.matrixWorld);let c=e.ray.origin.distanceTo(Ql);return c<e.near||c>e.far?null:{distance:c,point:Ql.clone(),object:i}}function tc(i,t,e,n,s,r,o,a,l,c){i.getVertexPosition(a,Zl),i.getVertexPosition(l,Jl),i.getVertexPosition(c,Kl);let f=Fv(i,t,e,n,Zl,Jl,Kl,Rm);if(f){let u=new X;ts.getBarycoord(Rm,Zl,Jl,Kl,u),s&&(f.uv=ts.getInterpolatedAttribute(s,a,l,c,u,new Jt)),r&&(f.uv1=ts.getInterpolatedAttribute(r,a,l,c,u,new Jt)),o&&(f.normal=ts.getInterpolatedAttribute(o,a,l,c,u,new X),f.normal.dot(n.direction)>0&&f.normal.multiplyScalar(-1));let h={a,b:l,c,normal:new X,materialIndex:0};ts.getNormal(Zl,Jl,Kl,h.normal),f.face=h,f.barycoord=u}return f}var Ec=class extends ti{constructor(t=null,e=1,n=1,s,r,o,a,l,c=Un,f=Un,u,h){super(null,o,a,l,c,f,s,r,u,h),this.isDataTexture=!0,this.image={data:t,width:e,height:n},this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}};var dr=new pr,Ov=new Jt(.5,.5),ec=new X,qs=class{constructor(t=new mi,e=new mi,n=new mi,s=new mi,r=new mi,o=new mi){this.planes=[t,e,n,s,r,o]}set(t,e,n,s,r,o){let a=this.planes;return a[0].copy(t),a[1].copy(e),a[2].copy(n),a[3].copy(s),a[4].copy(r),a[5].copy(o),this}copy(t){let e=this.planes;for(let n=0;n<6;n++)e[n].copy(t.planes[n]);return this}setFromProjectionMatrix(t,e=Ti,n=!1){let s=this.planes,r=t.elements,o=r[0],a=r[1],l=r[2],c=r[3],f=r[4],u=r[5],h=r[6],d=r[7],p=r[8],_=r[9],g=r[10],m=r[11],v=r[12],A=r[13],S=r[14],R=r[15];if(s[0].setComponents(c-o,d-f,m-p,R-v).normalize(),s[1].setComponents(c+o,d+f,m+p,R+v).normalize(),s[2].setComponents(c+a,d+u,m+_,R+A).normalize(),s[3].setComponents(c-a,d-u,m-_,R-A).normalize(),n)s[4].setComponents(l,h,g,S).normalize(),s[5].setComponents(c-l,d-h,m-g,R-S).normalize();else if(s[4].setComponents(c-l,d-h,m-g,R-S).normalize(),e===Ti)s[5].setComponents(c+l,d+h,m+g,R+S).normalize();else if(e===fo)s[5].setComponents(l,h,g,S).normalize();else throw new Error("THREE.Frustum.setFromProjectionMatrix(): Invalid coordinate system: "+e);return this}intersectsObject(t){if(t.boundingSphere!==void 0)t.boundingSphere===null&&t.computeBoundingSphere(),dr.copy(t.boundingSphere).applyMatrix4(t.matrixWorld);else{let e=t.geometry;e.boundingSphere===null&&e.computeBoundingSphere(),dr.copy(e.boundingSphere).applyMatrix4(t.matrixWorld)}return this.intersectsSphere(dr)}intersectsSprite(t){dr.center.set(0,0,0);let e=Ov.distanceTo(t.center);return dr.radius=.7071067811865476+e,dr.applyMatrix4(t.matrixWorld),this.intersectsSphere(dr)}intersectsSphere(t){let e=this.planes,n=t.center,s=-t.radius;for(let r=0;r<6;r++)if(e[r].distanceToPoint(n)<s)return!1;return!0}intersectsBox(t){let e=this.planes;for(let n=0;n<6;n++){let s=e[n];if(ec.x=s.normal.x>0?t.max.x:t.min.x,ec.y=s.normal.y>0?t.max.y:t.min.y,ec.z=s.normal.z>0?t.max.z:t.min.z,s.distanceToPoint(ec)<0)return!1}return!0}containsPoint(t){let e=this.planes;for(let n=0;n<6;n++)if(e[n].distanceToPoint(t)<0)return!1;return!0}clone(){return new this.constructor().copy(this)}},Pm=new De,Ac=class i{constructor(){this.coordinateSystem=Ti,this._frustums=[],this._count=0}setFromArrayCamera(t){let e=t.cameras,n=this._frustums;for(let s=0;s<e.length;s++){let r=e[s];Pm.multiplyMatrices(r.projectionMatrix,r.matrixWorldInverse),n[s]===void 0&&(n[s]=new qs),n[s].setFromProjectionMatrix(Pm,r.coordinateSystem,r.reversedDepth)}return this._count=e.length,this}getFrustum(t){return this._frustums[t]}intersectsObject(t){let e=this._frustums;for(let n=0;n<this._count;n++)if(e[n].intersectsObject(t))return!0;return!1}intersectsSprite(t){let e=this._frustums;for(let n=0;n<this._count;n++)if(e[n].intersectsSprite(t))return!0;return!1}intersectsSphere(t){let e=this._frustums;for(let n=0;n<this._count;n++)if(e[n].intersectsSphere(t))return!0;return!1}intersectsBox(t){let e=this._frustums;for(let n=0;n<this._count;n++)if(e[n].intersectsBox(t))return!0;return!1}containsPoint(t){let e=this._frustums;for(let n=0;n<this._count;n++)if(e[n].containsPoint(t))return!0;return!1}copy(t){this.coordinateSystem=t.coordinateSystem;let e=this._frustums,n=t._frustums;for(let s=0;s<t._count;s++)e[s]===void 0&&(e[s]=new qs),e[s].copy(n[s]);return this._count=t._count,this}clone(){return new i().copy(this)}};var Ei=class extends ns{constructor(t){super(),this.isLineBasicMaterial=!0,this.type="LineBasicMaterial",this.color=new ue(16777215),this.map=null,this.linewidth=1,this.linecap="round",this.linejoin="round",this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.color.copy(t.color),this.map=t.map,this.linewidth=t.linewidth,this.linecap=t.linecap,this.linejoin=t.linejoin,this.fog=t.fog,this}},Cc=new X,Rc=new X,Im=new De,oa=new mr,nc=new pr,Ju=new X,Lm=new X,yo=class extends Fn{constructor(t=new an,e=new Ei){super(),this.isLine=!0,this.type="Line",this.geometry=t,this.material=e,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.updateMorphTargets()}copy(t,e){return super.copy(t,e),t.morphTargetInfluences!==void 0?this.morphTargetInfluences=t.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,t.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},t.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(t.material)?t.material.slice():t.material,this.geometry=t.geometry,this}computeLineDistances(){let t=this.geometry;if(t.index===null){let e=t.attributes.position,n=[0];for(let s=1,r=e.count;s<r;s++)Cc.fromBufferAttribute(e,s-1),Rc.fromBufferAttribute(e,s),n[s]=n[s-1],n[s]+=Cc.distanceTo(Rc);t.setAttribute("lineDistance",new Re(n,1))}else jt("Line.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}intersectsFrustum(t){return t.intersectsObject(this)}raycast(t,e){let n=this.geometry,s=this.matrixWorld,r=t.params.Line.threshold,o=n.drawRange;if(n.boundingSphere===null&&n.computeBoundingSphere(),nc.copy(n.boundingSphere),nc.applyMatrix4(s),nc.radius+=r,t.ray.intersectsSphere(nc)===!1)return;Im.copy(s).invert(),oa.copy(t.ray).applyMatrix4(Im);let a=r/((this.scale.x+this.scale.y+this.scale.z)/3),l=a*a,c=this.isLineSegments?2:1,f=n.index,h=n.attributes.position;if(f!==null){let d=Math.max(0,o.start),p=Math.min(f.count,o.start+o.count);for(let _=d,g=p-1;_<g;_+=c){let m=f.getX(_),v=f.getX(_+1),A=ic(this,t,oa,l,m,v,_);A&&e.push(A)}if(this.isLineLoop){let _=f.getX(p-1),g=f.getX(d),m=ic(this,t,oa,l,_,g,p-1);m&&e.push(m)}}else{let d=Math.max(0,o.start),p=Math.min(h.count,o.start+o.count);for(let _=d,g=p-1;_<g;_+=c){let m=ic(this,t,oa,l,_,_+1,_);m&&e.push(m)}if(this.isLineLoop){let _=ic(this,t,oa,l,p-1,d,p-1);_&&e.push(_)}}}updateMorphTargets(){let e=this.geometry.morphAttributes,n=Object.keys(e);if(n.length>0){let s=e[n[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}};function ic(i,t,e,n,s,r,o){let a=i.geometry.attributes.position;if(Cc.fromBufferAttribute(a,s),Rc.fromBufferAttribute(a,r),e.distanceSqToSegment(Cc,Rc,Ju,Lm)>n)return;Ju.applyMatrix4(i.matrixWorld);let c=t.ray.origin.distanceTo(Ju);if(!(c<t.near||c>t.far))return{distance:c,point:Lm.clone().applyMatrix4(i.matrixWorld),index:o,face:null,faceIndex:null,barycoord:null,object:i}}var Dm=new X,Nm=new X,ss=class extends yo{constructor(t,e){super(t,e),this.isLineSegments=!0,this.type="LineSegments"}computeLineDistances(){let t=this.geometry;if(t.index===null){let e=t.attributes.position,n=[];for(let s=0,r=e.count;s<r;s+=2)Dm.fromBufferAttribute(e,s),Nm.fromBufferAttribute(e,s+1),n[s]=s===0?0:n[s-1],n[s+1]=n[s]+Dm.distanceTo(Nm);t.setAttribute("lineDistance",new Re(n,1))}else jt("LineSegments.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}};var Sa=class extends ti{constructor(t=[],e=vr,n,s,r,o,a,l,c,f){super(t,e,n,s,r,o,a,l,c,f),this.isCubeTexture=!0,this.flipY=!1}get images(){return this.image}set images(t){this.image=t}},Ma=class extends ti{constructor(t,e,n,s,r,o,a,l,c){super(t,e,n,s,r,o,a,l,c),this.isCanvasTexture=!0,this.needsUpdate=!0}};var Ts=class extends ti{constructor(t,e,n=Bi,s,r,o,a=Un,l=Un,c,f=bs,u=1){if(f!==bs&&f!==As)throw new Error("THREE.DepthTexture: format must be either THREE.DepthFormat or THREE.DepthStencilFormat");let h={width:t,height:e,depth:u};super(h,s,r,o,a,l,f,n,c),this.isDepthTexture=!0,this.flipY=!1,this.generateMipmaps=!1,this.compareFunction=null}copy(t){return super.copy(t),this.source=new go(Object.assign({},t.image)),this.compareFunction=t.compareFunction,this}toJSON(t){let e=super.toJSON(t);return e.compareFunction=this.compareFunction,e}},ba=class extends Ts{constructor(t,e=Bi,n=vr,s,r,o=Un,a=Un,l,c=bs){let f={width:t,height:t,depth:1},u=[f,f,f,f,f,f];super(t,t,e,n,s,r,o,a,l,c),this.image=u,this.isCubeDepthTexture=!0,this.isCubeTexture=!0}get images(){return this.image}set images(t){this.image=t}},wa=class extends ti{constructor(t=null){super(),this.sourceTexture=t,this.isExternalTexture=!0}copy(t){return super.copy(t),this.sourceTexture=t.sourceTexture,this}},_i=class i extends an{constructor(t=1,e=1,n=1,s=1,r=1,o=1){super(),this.type="BoxGeometry",this.parameters={width:t,height:e,depth:n,widthSegments:s,heightSegments:r,depthSegments:o};let a=this;s=Math.floor(s),r=Math.floor(r),o=Math.floor(o);let l=[],c=[],f=[],u=[],h=0,d=0;p("z","y","x",-1,-1,n,e,t,o,r,0),p("z","y","x",1,-1,n,e,-t,o,r,1),p("x","z","y",1,1,t,n,e,s,o,2),p("x","z","y",1,-1,t,n,-e,s,o,3),p("x","y","z",1,-1,t,e,n,s,r,4),p("x","y","z",-1,-1,t,e,-n,s,r,5),this.setIndex(l),this.setAttribute("position",new Re(c,3)),this.setAttribute("normal",new Re(f,3)),this.setAttribute("uv",new Re(u,2));function p(_,g,m,v,A,S,R,E,x,T,U){let N=S/x,L=R/T,z=S/2,O=R/2,P=E/2,G=x+1,q=T+1,H=0,ct=0,K=new X;for(let et=0;et<q;et++){let st=et*L-O;for(let pt=0;pt<G;pt++){let dt=pt*N-z;K[_]=dt*v,K[g]=st*A,K[m]=P,c.push(K.x,K.y,K.z),K[_]=0,K[g]=0,K[m]=E>0?1:-1,f.push(K.x,K.y,K.z),u.push(pt/x),u.push(1-et/T),H+=1}}for(let et=0;et<T;et++)for(let st=0;st<x;st++){let pt=h+st+G*et,dt=h+st+G*(et+1),Q=h+(st+1)+G*(et+1),_t=h+(st+1)+G*et;l.push(pt,dt,_t),l.push(dt,Q,_t),ct+=6}a.addGroup(d,ct,U),d+=ct,h+=H}}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new i(t.width,t.height,t.depth,t.widthSegments,t.heightSegments,t.depthSegments)}};var gr=class i extends an{constructor(t=1,e=1,n=1,s=32,r=1,o=!1,a=0,l=Math.PI*2){super(),this.type="CylinderGeometry",this.parameters={radiusTop:t,radiusBottom:e,height:n,radialSegments:s,heightSegments:r,openEnded:o,thetaStart:a,thetaLength:l};let c=this;s=Math.floor(s),r=Math.floor(r);let f=[],u=[],h=[],d=[],p=0,_=[],g=n/2,m=0;v(),o===!1&&(t>0&&A(!0),e>0&&A(!1)),this.setIndex(f),this.setAttribute("position",new Re(u,3)),this.setAttribute("normal",new Re(h,3)),this.setAttribute("uv",new Re(d,2));function v(){let S=new X,R=new X,E=0,x=(e-t)/n;for(let T=0;T<=r;T++){let U=[],N=T/r,L=N*(e-t)+t;for(let z=0;z<=s;z++){let O=z/s,P=O*l+a,G=Math.sin(P),q=Math.cos(P);R.x=L*G,R.y=-N*n+g,R.z=L*q,u.push(R.x,R.y,R.z),S.set(G,x,q).normalize(),h.push(S.x,S.y,S.z),d.push(O,1-N),U.push(p++)}_.push(U)}for(let T=0;T<s;T++)for(let U=0;U<r;U++){let N=_[U][T],L=_[U+1][T],z=_[U+1][T+1],O=_[U][T+1];(t>0||U!==0)&&(f.push(N,L,O),E+=3),(e>0||U!==r-1)&&(f.push(L,z,O),E+=3)}c.addGroup(m,E,0),m+=E}function A(S){let R=p,E=new Jt,x=new X,T=0,U=S===!0?t:e,N=S===!0?1:-1;for(let z=1;z<=s;z++)u.push(0,g*N,0),h.push(0,N,0),d.push(.5,.5),p++;let L=p;for(let z=0;z<=s;z++){let P=z/s*l+a,G=Math.cos(P),q=Math.sin(P);x.x=U*q,x.y=g*N,x.z=U*G,u.push(x.x,x.y,x.z),h.push(0,N,0),E.x=G*.5+.5,E.y=q*.5*N+.5,d.push(E.x,E.y),p++}for(let z=0;z<s;z++){let O=R+z,P=L+z;S===!0?f.push(P,P+1,O):f.push(P+1,P,O),T+=3}c.addGroup(m,T,S===!0?1:2),m+=T}}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new i(t.radiusTop,t.radiusBottom,t.height,t.radialSegments,t.heightSegments,t.openEnded,t.thetaStart,t.thetaLength)}};var sc=new X,rc=new X,Ku=new X,oc=new ts,Ta=class extends an{constructor(t=null,e=1){if(super(),this.type="EdgesGeometry",this.parameters={geometry:t,thresholdAngle:e},t!==null){let s=Math.pow(10,4),r=Math.cos(co*e),o=t.getIndex(),a=t.getAttribute("position"),l=o?o.count:a.count,c=[0,0,0],f=["a","b","c"],u=new Array(3),h=new Map,d=[];for(let p=0;p<l;p+=3){o?(c[0]=o.getX(p),c[1]=o.getX(p+1),c[2]=o.getX(p+2)):(c[0]=p,c[1]=p+1,c[2]=p+2);let{a:_,b:g,c:m}=oc;if(_.fromBufferAttribute(a,c[0]),g.fromBufferAttribute(a,c[1]),m.fromBufferAttribute(a,c[2]),oc.getNormal(Ku),u[0]=`${Math.round(_.x*s)},${Math.round(_.y*s)},${Math.round(_.z*s)}`,u[1]=`${Math.round(g.x*s)},${Math.round(g.y*s)},${Math.round(g.z*s)}`,u[2]=`${Math.round(m.x*s)},${Math.round(m.y*s)},${Math.round(m.z*s)}`,!(u[0]===u[1]||u[1]===u[2]||u[2]===u[0]))for(let v=0;v<3;v++){let A=(v+1)%3,S=u[v],R=u[A],E=oc[f[v]],x=oc[f[A]],T=`${S}_${R}`,U=`${R}_${S}`,N=h.get(U);N?(Ku.dot(N.normal)<=r&&(d.push(E.x,E.y,E.z),d.push(x.x,x.y,x.z)),h.set(U,null)):h.has(T)||h.set(T,{index0:c[v],index1:c[A],normal:Ku.clone()})}}for(let p of h.values())if(p){let{index0:_,index1:g}=p;sc.fromBufferAttribute(a,_),rc.fromBufferAttribute(a,g),d.push(sc.x,sc.y,sc.z),d.push(rc.x,rc.y,rc.z)}this.setAttribute("position",new Re(d,3))}}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}};var Ea=class i extends an{constructor(t=1,e=1,n=1,s=1){super(),this.type="PlaneGeometry",this.parameters={width:t,height:e,widthSegments:n,heightSegments:s};let r=t/2,o=e/2,a=Math.floor(n),l=Math.floor(s),c=a+1,f=l+1,u=t/a,h=e/l,d=[],p=[],_=[],g=[];for(let m=0;m<f;m++){let v=m*h-o;for(let A=0;A<c;A++){let S=A*u-r;p.push(S,-v,0),_.push(0,0,1),g.push(A/a),g.push(1-m/l)}}for(let m=0;m<l;m++)for(let v=0;v<a;v++){let A=v+c*m,S=v+c*(m+1),R=v+1+c*(m+1),E=v+1+c*m;d.push(A,S,E),d.push(S,R,E)}this.setIndex(d),this.setAttribute("position",new Re(p,3)),this.setAttribute("normal",new Re(_,3)),this.setAttribute("uv",new Re(g,2))}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new i(t.width,t.height,t.widthSegments,t.heightSegments)}},Aa=class i extends an{constructor(t=.5,e=1,n=32,s=1,r=0,o=Math.PI*2){super(),this.type="RingGeometry",this.parameters={innerRadius:t,outerRadius:e,thetaSegments:n,phiSegments:s,thetaStart:r,thetaLength:o},n=Math.max(3,n),s=Math.max(1,s);let a=[],l=[],c=[],f=[],u=t,h=(e-t)/s,d=new X,p=new Jt;for(let _=0;_<=s;_++){for(let g=0;g<=n;g++){let m=r+g/n*o;d.x=u*Math.cos(m),d.y=u*Math.sin(m),l.push(d.x,d.y,d.z),c.push(0,0,1),p.x=(d.x/e+1)/2,p.y=(d.y/e+1)/2,f.push(p.x,p.y)}u+=h}for(let _=0;_<s;_++){let g=_*(n+1);for(let m=0;m<n;m++){let v=m+g,A=v,S=v+n+1,R=v+n+2,E=v+1;a.push(A,S,E),a.push(S,R,E)}}this.setIndex(a),this.setAttribute("position",new Re(l,3)),this.setAttribute("normal",new Re(c,3)),this.setAttribute("uv",new Re(f,2))}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new i(t.innerRadius,t.outerRadius,t.thetaSegments,t.phiSegments,t.thetaStart,t.thetaLength)}};var _r=class i extends an{constructor(t=1,e=32,n=16,s=0,r=Math.PI*2,o=0,a=Math.PI){super(),this.type="SphereGeometry",this.parameters={radius:t,widthSegments:e,heightSegments:n,phiStart:s,phiLength:r,thetaStart:o,thetaLength:a},e=Math.max(3,Math.floor(e)),n=Math.max(2,Math.floor(n));let l=Math.min(o+a,Math.PI),c=0,f=[],u=new X,h=new X,d=[],p=[],_=[],g=[];for(let m=0;m<=n;m++){let v=[],A=m/n,S=o+A*a,R=t*Math.cos(S),E=Math.sqrt(t*t-R*R),x=0;m===0&&o===0?x=.5/e:m===n&&l===Math.PI&&(x=-.5/e);for(let T=0;T<=e;T++){let U=T/e,N=s+U*r;u.x=-E*Math.cos(N),u.y=R,u.z=E*Math.sin(N),p.push(u.x,u.y,u.z),h.copy(u).normalize(),_.push(h.x,h.y,h.z),g.push(U+x,1-A),v.push(c++)}f.push(v)}for(let m=0;m<n;m++)for(let v=0;v<e;v++){let A=f[m][v+1],S=f[m][v],R=f[m+1][v],E=f[m+1][v+1];(m!==0||o>0)&&d.push(A,S,E),(m!==n-1||l<Math.PI)&&d.push(S,R,E)}this.setIndex(d),this.setAttribute("position",new Re(p,3)),this.setAttribute("normal",new Re(_,3)),this.setAttribute("uv",new Re(g,2))}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new i(t.radius,t.widthSegments,t.heightSegments,t.phiStart,t.phiLength,t.thetaStart,t.thetaLength)}};function Mr(i){let t={};for(let e in i){t[e]={};for(let n in i[e]){let s=i[e][n];if(Um(s))s.isRenderTargetTexture?(jt("UniformsUtils: Textures of render targets cannot be cloned via cloneUniforms() or mergeUniforms()."),t[e][n]=null):t[e][n]=s.clone();else if(Array.isArray(s))if(Um(s[0])){let r=[];for(let o=0,a=s.length;o<a;o++)r[o]=s[o].clone();t[e][n]=r}else t[e][n]=s.slice();else t[e][n]=s}}return t}function Hn(i){let t={};for(let e=0;e<i.length;e++){let n=Mr(i[e]);for(let s in n)t[s]=n[s]}return t}function Um(i){return i&&(i.isColor||i.isMatrix3||i.isMatrix4||i.isVector2||i.isVector3||i.isVector4||i.isTexture||i.isQuaternion)}function Bv(i){let t=[];for(let e=0;e<i.length;e++)t.push(i[e].clone());return t}function kf(i){let t=i.getRenderTarget();return t===null?i.outputColorSpace:t.isXRRenderTarget===!0?t.texture.colorSpace:Me.workingColorSpace}var Eg={clone:Mr,merge:Hn},kv=`void main() {
	gl_Position = projectionMatrix * modelViewMatrix * vec4( position, 1.0 );
}`,zv=`void main() {
	gl_FragColor = vec4( 1.0, 0.0, 0.0, 1.0 );
}`,rs=class extends ns{constructor(t){super(),this.isShaderMaterial=!0,this.type="ShaderMaterial",this.defines={},this.uniforms={},this.uniformsGroups=[],this.vertexShader=kv,this.fragmentShader=zv,this.linewidth=1,this.wireframe=!1,this.wireframeLinewidth=1,this.fog=!1,this.lights=!1,this.clipping=!1,this.forceSinglePass=!0,this.extensions={clipCullDistance:!1,multiDraw:!1},this.defaultAttributeValues={color:[1,1,1],uv:[0,0],uv1:[0,0]},this.index0AttributeName=void 0,this.uniformsNeedUpdate=!1,this.glslVersion=null,t!==void 0&&this.setValues(t)}copy(t){return super.copy(t),this.fragmentShader=t.fragmentShader,this.vertexShader=t.vertexShader,this.uniforms=Mr(t.uniforms),this.uniformsGroups=Bv(t.uniformsGroups),this.defines=Object.assign({},t.defines),this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this.fog=t.fog,this.lights=t.lights,this.clipping=t.clipping,this.extensions=Object.assign({},t.extensions),this.glslVersion=t.glslVersion,this.defaultAttributeValues=Object.assign({},t.defaultAttributeValues),this.index0AttributeName=t.index0AttributeName,this.uniformsNeedUpdate=t.uniformsNeedUpdate,this}toJSON(t){let e=super.toJSON(t);e.glslVersion=this.glslVersion,e.uniforms={};for(let s in this.uniforms){let o=this.uniforms[s].value;o&&o.isTexture?e.uniforms[s]={type:"t",value:o.toJSON(t).uuid}:o&&o.isColor?e.uniforms[s]={type:"c",value:o.getHex()}:o&&o.isVector2?e.uniforms[s]={type:"v2",value:o.toArray()}:o&&o.isVector3?e.uniforms[s]={type:"v3",value:o.toArray()}:o&&o.isVector4?e.uniforms[s]={type:"v4",value:o.toArray()}:o&&o.isMatrix3?e.uniforms[s]={type:"m3",value:o.toArray()}:o&&o.isMatrix4?e.uniforms[s]={type:"m4",value:o.toArray()}:e.uniforms[s]={value:o}}Object.keys(this.defines).length>0&&(e.defines=this.defines),e.vertexShader=this.vertexShader,e.fragmentShader=this.fragmentShader,e.lights=this.lights,e.clipping=this.clipping;let n={};for(let s in this.extensions)this.extensions[s]===!0&&(n[s]=!0);return Object.keys(n).length>0&&(e.extensions=n),e}fromJSON(t,e){if(super.fromJSON(t,e),t.uniforms!==void 0)for(let n in t.uniforms){let s=t.uniforms[n];switch(this.uniforms[n]={},s.type){case"t":this.uniforms[n].value=e[s.value]||null;break;case"c":this.uniforms[n].value=new ue().setHex(s.value);break;case"v2":this.uniforms[n].value=new Jt().fromArray(s.value);break;case"v3":this.uniforms[n].value=new X().fromArray(s.value);break;case"v4":this.uniforms[n].value=new Qe().fromArray(s.value);break;case"m3":this.uniforms[n].value=new oe().fromArray(s.value);break;case"m4":this.uniforms[n].value=new De().fromArray(s.value);break;default:this.uniforms[n].value=s.value}}if(t.defines!==void 0&&(this.defines=t.defines),t.vertexShader!==void 0&&(this.vertexShader=t.vertexShader),t.fragmentShader!==void 0&&(this.fragmentShader=t.fragmentShader),t.glslVersion!==void 0&&(this.glslVersion=t.glslVersion),t.extensions!==void 0)for(let n in t.extensions)this.extensions[n]=t.extensions[n];return t.lights!==void 0&&(this.lights=t.lights),t.clipping!==void 0&&(this.clipping=t.clipping),this}},Pc=class extends rs{constructor(t){super(t),this.isRawShaderMaterial=!0,this.type="RawShaderMaterial"}},os=class extends ns{constructor(t){super(),this.isMeshStandardMaterial=!0,this.type="MeshStandardMaterial",this.defines={STANDARD:""},this.color=new ue(16777215),this.roughness=1,this.metalness=0,this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.emissive=new ue(0),this.emissiveIntensity=1,this.emissiveMap=null,this.bumpMap=null,this.bumpScale=1,this.normalMap=null,this.normalMapType=Ph,this.normalScale=new Jt(1,1),this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.roughnessMap=null,this.metalnessMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new ws,this.envMapIntensity=1,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.flatShading=!1,this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.defines={STANDARD:""},this.color.copy(t.color),this.roughness=t.roughness,this.metalness=t.metalness,this.map=t.map,this.lightMap=t.lightMap,this.lightMapIntensity=t.lightMapIntensity,this.aoMap=t.aoMap,this.aoMapIntensity=t.aoMapIntensity,this.emissive.copy(t.emissive),this.emissiveMap=t.emissiveMap,this.emissiveIntensity=t.emissiveIntensity,this.bumpMap=t.bumpMap,this.bumpScale=t.bumpScale,this.normalMap=t.normalMap,this.normalMapType=t.normalMapType,this.normalScale.copy(t.normalScale),this.displacementMap=t.displacementMap,this.displacementScale=t.displacementScale,this.displacementBias=t.displacementBias,this.roughnessMap=t.roughnessMap,this.metalnessMap=t.metalnessMap,this.alphaMap=t.alphaMap,this.envMap=t.envMap,this.envMapRotation.copy(t.envMapRotation),this.envMapIntensity=t.envMapIntensity,this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this.wireframeLinecap=t.wireframeLinecap,this.wireframeLinejoin=t.wireframeLinejoin,this.flatShading=t.flatShading,this.fog=t.fog,this}};var Ic=class extends ns{constructor(t){super(),this.isMeshDepthMaterial=!0,this.type="MeshDepthMaterial",this.depthPacking=fg,this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.wireframe=!1,this.wireframeLinewidth=1,this.setValues(t)}copy(t){return super.copy(t),this.depthPacking=t.depthPacking,this.map=t.map,this.alphaMap=t.alphaMap,this.displacementMap=t.displacementMap,this.displacementScale=t.displacementScale,this.displacementBias=t.displacementBias,this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this}},Lc=class extends ns{constructor(t){super(),this.isMeshDistanceMaterial=!0,this.type="MeshDistanceMaterial",this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.setValues(t)}copy(t){return super.copy(t),this.map=t.map,this.alphaMap=t.alphaMap,this.displacementMap=t.displacementMap,this.displacementScale=t.displacementScale,this.displacementBias=t.displacementBias,this}};var Ca=class extends Ei{constructor(t){super(),this.isLineDashedMaterial=!0,this.type="LineDashedMaterial",this.scale=1,this.dashSize=3,this.gapSize=1,this.setValues(t)}copy(t){return super.copy(t),this.scale=t.scale,this.dashSize=t.dashSize,this.gapSize=t.gapSize,this}};function oo(i,t){return!i||i.constructor===t?i:typeof t.BYTES_PER_ELEMENT=="number"?new t(i):Array.prototype.slice.call(i)}function ac(i){return i!==void 0&&i.inTangents!==void 0&&i.outTangents!==void 0}var $s=class{constructor(t,e,n,s){this.parameterPositions=t,this._cachedIndex=0,this.resultBuffer=s!==void 0?s:new e.constructor(n),this.sampleValues=e,this.valueSize=n,this.settings=null,this.DefaultSettings_={}}evaluate(t){let e=this.parameterPositions,n=this._cachedIndex,s=e[n],r=e[n-1];n:{t:{let o;e:{i:if(!(t<s)){for(let a=n+2;;){if(s===void 0){if(t<r)break i;return n=e.length,this._cachedIndex=n,this.copySampleValue_(n-1)}if(n===a)break;if(r=s,s=e[++n],t<s)break t}o=e.length;break e}if(!(t>=r)){let a=e[1];t<a&&(n=2,r=a);for(let l=n-2;;){if(r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(n===l)break;if(s=r,r=e[--n-1],t>=r)break t}o=n,n=0;break e}break n}for(;n<o;){let a=n+o>>>1;t<e[a]?o=a:n=a+1}if(s=e[n],r=e[n-1],r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(s===void 0)return n=e.length,this._cachedIndex=n,this.copySampleValue_(n-1)}this._cachedIndex=n,this.intervalChanged_(n,r,s)}return this.interpolate_(n,r,t,s)}getSettings_(){return this.settings||this.DefaultSettings_}copySampleValue_(t){let e=this.resultBuffer,n=this.sampleValues,s=this.valueSize,r=t*s;for(let o=0;o!==s;++o)e[o]=n[r+o];return e}interpolate_(){throw new Error("THREE.Interpolant: Call to abstract method.")}intervalChanged_(){}},Dc=class extends $s{constructor(t,e,n,s){super(t,e,n,s),this._weightPrev=-0,this._offsetPrev=-0,this._weightNext=-0,this._offsetNext=-0,this.DefaultSettings_={endingStart:tf,endingEnd:tf}}intervalChanged_(t,e,n){let s=this.parameterPositions,r=t-2,o=t+1,a=s[r],l=s[o];if(a===void 0)switch(this.getSettings_().endingStart){case ef:r=t,a=2*e-n;break;case nf:r=s.length-2,a=e+s[r]-s[r+1];break;default:r=t,a=n}if(l===void 0)switch(this.getSettings_().endingEnd){case ef:o=t,l=2*n-e;break;case nf:o=1,l=n+s[1]-s[0];break;default:o=t-1,l=e}let c=(n-e)*.5,f=this.valueSize;this._weightPrev=c/(e-a),this._weightNext=c/(l-n),this._offsetPrev=r*f,this._offsetNext=o*f}interpolate_(t,e,n,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=t*a,c=l-a,f=this._offsetPrev,u=this._offsetNext,h=this._weightPrev,d=this._weightNext,p=(n-e)/(s-e),_=p*p,g=_*p,m=-h*g+2*h*_-h*p,v=(1+h)*g+(-1.5-2*h)*_+(-.5+h)*p+1,A=(-1-d)*g+(1.5+d)*_+.5*p,S=d*g-d*_;for(let R=0;R!==a;++R)r[R]=m*o[f+R]+v*o[c+R]+A*o[l+R]+S*o[u+R];return r}},Nc=class extends $s{constructor(t,e,n,s){super(t,e,n,s)}interpolate_(t,e,n,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=t*a,c=l-a,f=(n-e)/(s-e),u=1-f;for(let h=0;h!==a;++h)r[h]=o[c+h]*u+o[l+h]*f;return r}},Uc=class extends $s{constructor(t,e,n,s){super(t,e,n,s)}interpolate_(t){return this.copySampleValue_(t-1)}},Fc=class extends $s{interpolate_(t,e,n,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=t*a,c=l-a,f=this.inTangents,u=this.outTangents;if(!f||!u){let p=(n-e)/(s-e),_=1-p;for(let g=0;g!==a;++g)r[g]=o[c+g]*_+o[l+g]*p;return r}let h=a*2,d=t-1;for(let p=0;p!==a;++p){let _=o[c+p],g=o[l+p],m=d*h+p*2,v=u[m],A=u[m+1],S=t*h+p*2,R=f[S],E=f[S+1],x=Gv(n,e,v,R,s);r[p]=Ag(x,_,A,E,g)}return r}};function Ag(i,t,e,n,s){let r=1-i;return r*r*r*t+3*r*r*i*e+3*r*i*i*n+i*i*i*s}function Vv(i,t,e,n,s){let r=1-i;return 3*r*r*(e-t)+6*r*i*(n-e)+3*i*i*(s-n)}function Gv(i,t,e,n,s){let r=(i-t)/(s-t);for(let o=0;o<8;o++){let a=Ag(r,t,e,n,s)-i;if(Math.abs(a)<1e-10)break;let l=Vv(r,t,e,n,s);if(Math.abs(l)<1e-10)break;r=Math.max(0,Math.min(1,r-a/l))}return r}var xi=class{constructor(t,e,n,s){if(t===void 0)throw new Error("THREE.KeyframeTrack: track name is undefined");if(e===void 0||e.length===0)throw new Error("THREE.KeyframeTrack: no keyframes in track named "+t);this.name=t,this.times=oo(e,this.TimeBufferType),this.values=oo(n,this.ValueBufferType),this.setInterpolation(s||this.DefaultInterpolation)}static toJSON(t){let e=t.constructor,n;if(e.toJSON!==this.toJSON)n=e.toJSON(t);else{n={name:t.name,times:oo(t.times,Array),values:oo(t.values,Array)};let s=t.getInterpolation();s!==t.DefaultInterpolation&&(n.interpolation=s),ac(t.settings)&&(n.settings={inTangents:oo(t.settings.inTangents,Array),outTangents:oo(t.settings.outTangents,Array)})}return n.type=t.ValueTypeName,n}InterpolantFactoryMethodDiscrete(t){return new Uc(this.times,this.values,this.getValueSize(),t)}InterpolantFactoryMethodLinear(t){return new Nc(this.times,this.values,this.getValueSize(),t)}InterpolantFactoryMethodSmooth(t){return new Dc(this.times,this.values,this.getValueSize(),t)}InterpolantFactoryMethodBezier(t){let e=new Fc(this.times,this.values,this.getValueSize(),t);return this.settings&&(e.inTangents=this.settings.inTangents,e.outTangents=this.settings.outTangents),e}setInterpolation(t){let e;switch(t){case ca:e=this.InterpolantFactoryMethodDiscrete;break;case Sc:e=this.InterpolantFactoryMethodLinear;break;case hc:e=this.InterpolantFactoryMethodSmooth;break;case Qu:e=this.InterpolantFactoryMethodBezier;break}if(e===void 0){let n="unsupported interpolation for "+this.ValueTypeName+" keyframe track named "+this.name;if(this.createInterpolant===void 0)if(t!==this.DefaultInterpolation)this.setInterpolation(this.DefaultInterpolation);else throw new Error(n);return jt("KeyframeTrack:",n),this}return this.createInterpolant=e,this}getInterpolation(){switch(this.createInterpolant){case this.InterpolantFactoryMethodDiscrete:return ca;case this.InterpolantFactoryMethodLinear:return Sc;case this.InterpolantFactoryMethodSmooth:return hc;case this.InterpolantFactoryMethodBezier:return Qu}}getValueSize(){return this.values.length/this.times.length}shift(t){if(t!==0){let e=this.times;for(let n=0,s=e.length;n!==s;++n)e[n]+=t;ac(this.settings)&&(Fm(this.settings.inTangents,t),Fm(this.settings.outTangents,t))}return this}scale(t){if(t!==1){let e=this.times;for(let n=0,s=e.length;n!==s;++n)e[n]*=t;ac(this.settings)&&(Om(this.settings.inTangents,t),Om(this.settings.outTangents,t))}return this}trim(t,e){let n=this.times,s=n.length,r=0,o=s-1;for(;r!==s&&n[r]<t;)++r;for(;o!==-1&&n[o]>e;)--o;if(++o,r!==0||o!==s){r>=o&&(o=Math.max(o,1),r=o-1);let a=this.getValueSize();this.times=n.slice(r,o),this.values=this.values.slice(r*a,o*a)}return this}validate(){let t=!0,e=this.getValueSize();e-Math.floor(e)!==0&&(se("KeyframeTrack: Invalid value size in track.",this),t=!1);let n=this.times,s=this.values,r=n.length;r===0&&(se("KeyframeTrack: Track is empty.",this),t=!1);let o=null;for(let a=0;a!==r;a++){let l=n[a];if(typeof l=="number"&&isNaN(l)){se("KeyframeTrack: Time is not a valid number.",this,a,l),t=!1;break}if(o!==null&&o>l){se("KeyframeTrack: Out of order keys.",this,a,l,o),t=!1;break}o=l}if(s!==void 0&&sv(s))for(let a=0,l=s.length;a!==l;++a){let c=s[a];if(isNaN(c)){se("KeyframeTrack: Value is not a valid number.",this,a,c),t=!1;break}}return t}optimize(){let t=this.times.slice(),e=this.values.slice(),n=this.getValueSize(),s=this.getInterpolation()===hc,r=t.length-1,o=1;for(let a=1;a<r;++a){let l=!1,c=t[a],f=t[a+1];if(c!==f&&(a!==1||c!==t[0]))if(s)l=!0;else{let u=a*n,h=u-n,d=u+n;for(let p=0;p!==n;++p){let _=e[u+p];if(_!==e[h+p]||_!==e[d+p]){l=!0;break}}}if(l){if(a!==o){t[o]=t[a];let u=a*n,h=o*n;for(let d=0;d!==n;++d)e[h+d]=e[u+d]}++o}}if(r>0){t[o]=t[r];for(let a=r*n,l=o*n,c=0;c!==n;++c)e[l+c]=e[a+c];++o}return o!==t.length?(this.times=t.slice(0,o),this.values=e.slice(0,o*n)):(this.times=t,this.values=e),this}clone(){let t=this.times.slice(),e=this.values.slice(),n=this.constructor,s=new n(this.name,t,e);return s.createInterpolant=this.createInterpolant,ac(this.settings)&&(s.settings={inTangents:this.settings.inTangents.slice(),outTangents:this.settings.outTangents.slice()}),s}};function Fm(i,t){for(let e=0,n=i.length;e!==n;e+=2)i[e]+=t}function Om(i,t){for(let e=0,n=i.length;e!==n;e+=2)i[e]*=t}xi.prototype.ValueTypeName="";xi.prototype.TimeBufferType=Float32Array;xi.prototype.ValueBufferType=Float32Array;xi.prototype.DefaultInterpolation=Sc;var Ys=class extends xi{constructor(t,e,n){super(t,e,n)}};Ys.prototype.ValueTypeName="bool";Ys.prototype.ValueBufferType=Array;Ys.prototype.DefaultInterpolation=ca;Ys.prototype.InterpolantFactoryMethodLinear=void 0;Ys.prototype.InterpolantFactoryMethodSmooth=void 0;var Oc=class extends xi{constructor(t,e,n,s){super(t,e,n,s)}};Oc.prototype.ValueTypeName="color";var Bc=class extends xi{constructor(t,e,n,s){super(t,e,n,s)}};Bc.prototype.ValueTypeName="number";var kc=class extends $s{constructor(t,e,n,s){super(t,e,n,s)}interpolate_(t,e,n,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=(n-e)/(s-e),c=t*a;for(let f=c+a;c!==f;c+=4)Qn.slerpFlat(r,0,o,c-a,o,c,l);return r}},Ra=class extends xi{constructor(t,e,n,s){super(t,e,n,s)}InterpolantFactoryMethodLinear(t){return new kc(this.times,this.values,this.getValueSize(),t)}};Ra.prototype.ValueTypeName="quaternion";Ra.prototype.InterpolantFactoryMethodSmooth=void 0;var Zs=class extends xi{constructor(t,e,n){super(t,e,n)}};Zs.prototype.ValueTypeName="string";Zs.prototype.ValueBufferType=Array;Zs.prototype.DefaultInterpolation=ca;Zs.prototype.InterpolantFactoryMethodLinear=void 0;Zs.prototype.InterpolantFactoryMethodSmooth=void 0;var zc=class extends xi{constructor(t,e,n,s){super(t,e,n,s)}};zc.prototype.ValueTypeName="vector";var Vc=class{constructor(t,e,n){let s=this,r=!1,o=0,a=0,l,c=[];this.onStart=void 0,this.onLoad=t,this.onProgress=e,this.onError=n,this._abortController=null,this.itemStart=function(f){a++,r===!1&&s.onStart!==void 0&&s.onStart(f,o,a),r=!0},this.itemEnd=function(f){o++,s.onProgress!==void 0&&s.onProgress(f,o,a),o===a&&(r=!1,s.onLoad!==void 0&&s.onLoad())},this.itemError=function(f){s.onError!==void 0&&s.onError(f)},this.resolveURL=function(f){return f=f.normalize("NFC"),l?l(f):f},this.setURLModifier=function(f){return l=f,this},this.addHandler=function(f,u){return c.push(f,u),this},this.removeHandler=function(f){let u=c.indexOf(f);return u!==-1&&c.splice(u,2),this},this.getHandler=function(f){for(let u=0,h=c.length;u<h;u+=2){let d=c[u],p=c[u+1];if(d.global&&(d.lastIndex=0),d.test(f))return p}return null},this.abort=function(){return this.abortController.abort(),this._abortController=null,this}}get abortController(){return this._abortController||(this._abortController=new AbortController),this._abortController}},Cg=new Vc,Gc=class{constructor(t){this.manager=t!==void 0?t:Cg,this.crossOrigin="anonymous",this.withCredentials=!1,this.path="",this.resourcePath="",this.requestHeader={},this.priority="auto",this.cache="default",typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}load(){}loadAsync(t,e){let n=this;return new Promise(function(s,r){n.load(t,s,e,r)})}parse(){}setCrossOrigin(t){return this.crossOrigin=t,this}setWithCredentials(t){return this.withCredentials=t,this}setPath(t){return this.path=t,this}setResourcePath(t){return this.resourcePath=t,this}setRequestHeader(t){return this.requestHeader=t,this}setPriority(t){return this.priority=t,this}setCache(t){return this.cache=t,this}abort(){return this}};Gc.DEFAULT_MATERIAL_NAME="__DEFAULT";var vo=class extends Fn{static registerNode(t){this.prototype._lightNode=t}constructor(t,e=1){super(),this.isLight=!0,this.type="Light",this.color=new ue(t),this.intensity=e}copy(t,e){return super.copy(t,e),this.color.copy(t.color),this.intensity=t.intensity,this}toJSON(t){let e=super.toJSON(t);return e.object.color=this.color.getHex(),e.object.intensity=this.intensity,e}},Pa=class extends vo{constructor(t,e,n){super(t,n),this.isHemisphereLight=!0,this.type="HemisphereLight",this.position.copy(Fn.DEFAULT_UP),this.updateMatrix(),this.groundColor=new ue(e)}copy(t,e){return super.copy(t,e),this.groundColor.copy(t.groundColor),this}toJSON(t){let e=super.toJSON(t);return e.object.groundColor=this.groundColor.getHex(),e}},ju=new De,Bm=new X,km=new X,Hc=class{constructor(t){this.camera=t,this.intensity=1,this.bias=0,this.biasNode=null,this.normalBias=0,this.radius=1,this.blurSamples=8,this.mapSize=new Jt(512,512),this.mapType=ai,this.map=null,this.mapPass=null,this.matrix=new De,this.autoUpdate=!0,this.needsUpdate=!1,this._frustum=new qs,this._frameExtents=new Jt(1,1),this._viewportCount=1,this._viewports=[new Qe(0,0,1,1)]}getViewportCount(){return this._viewportCount}getCamera(){return this.camera}getFrustum(){return this._frustum}updateMatrices(t){let e=this.camera;Bm.setFromMatrixPosition(t.matrixWorld),e.position.copy(Bm),km.setFromMatrixPosition(t.target.matrixWorld),e.lookAt(km),e.updateMatrixWorld(),this._updateMatrix(e,this.matrix,this._frustum)}_updateMatrix(t,e,n,s){ju.multiplyMatrices(t.projectionMatrix,t.matrixWorldInverse),n.setFromProjectionMatrix(ju,t.coordinateSystem,t.reversedDepth);let r=this._frameExtents,o=s?s.z/r.x:1,a=s?s.w/r.y:1,l=s?s.x/r.x:0,c=s?s.y/r.y:0;t.coordinateSystem===fo||t.reversedDepth?e.set(.5*o,0,0,.5*o+l,0,.5*a,0,.5*a+c,0,0,1,0,0,0,0,1):e.set(.5*o,0,0,.5*o+l,0,.5*a,0,.5*a+c,0,0,.5,.5,0,0,0,1),e.multiply(ju)}getViewport(t){return this._viewports[t]}getFrameExtents(){return this._frameExtents}dispose(){this.map&&this.map.dispose(),this.mapPass&&this.mapPass.dispose()}copy(t){return this.camera=t.camera.clone(),this.intensity=t.intensity,this.bias=t.bias,this.radius=t.radius,this.autoUpdate=t.autoUpdate,this.needsUpdate=t.needsUpdate,this.normalBias=t.normalBias,this.blurSamples=t.blurSamples,this.mapSize.copy(t.mapSize),this.mapType=t.mapType,this.biasNode=t.biasNode,this}clone(){return new this.constructor().copy(this)}toJSON(){let t={};return t.intensity=this.intensity,t.bias=this.bias,t.normalBias=this.normalBias,t.radius=this.radius,t.blurSamples=this.blurSamples,t.mapSize=this.mapSize.toArray(),t.mapType=this.mapType,t.camera=this.camera.toJSON(!1).object,delete t.camera.matrix,t}},lc=new X,cc=new Qn,Qi=new X,Ia=class extends Fn{constructor(){super(),this.isCamera=!0,this.type="Camera",this.matrixWorldInverse=new De,this.projectionMatrix=new De,this.projectionMatrixInverse=new De,this.coordinateSystem=Ti,this._reversedDepth=!1}get reversedDepth(){return this._reversedDepth}copy(t,e){return super.copy(t,e),this.matrixWorldInverse.copy(t.matrixWorldInverse),this.projectionMatrix.copy(t.projectionMatrix),this.projectionMatrixInverse.copy(t.projectionMatrixInverse),this.coordinateSystem=t.coordinateSystem,this}getWorldDirection(t){return super.getWorldDirection(t).negate()}updateMatrixWorld(t){super.updateMatrixWorld(t),this.matrixWorld.decompose(lc,cc,Qi),Qi.x===1&&Qi.y===1&&Qi.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(lc,cc,Qi.set(1,1,1)).invert()}updateWorldMatrix(t,e,n=!1){super.updateWorldMatrix(t,e,n),this.matrixWorld.decompose(lc,cc,Qi),Qi.x===1&&Qi.y===1&&Qi.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(lc,cc,Qi.set(1,1,1)).invert()}clone(){return new this.constructor().copy(this)}},Ws=new X,zm=new Jt,Vm=new Jt,Kn=class extends Ia{constructor(t=50,e=1,n=.1,s=2e3){super(),this.isPerspectiveCamera=!0,this.type="PerspectiveCamera",this.fov=t,this.zoom=1,this.near=n,this.far=s,this.focus=10,this.aspect=e,this.view=null,this.filmGauge=35,this.filmOffset=0,this.updateProjectionMatrix()}copy(t,e){return super.copy(t,e),this.fov=t.fov,this.zoom=t.zoom,this.near=t.near,this.far=t.far,this.focus=t.focus,this.aspect=t.aspect,this.view=t.view===null?null:Object.assign({},t.view),this.filmGauge=t.filmGauge,this.filmOffset=t.filmOffset,this}setFocalLength(t){let e=.5*this.getFilmHeight()/t;this.fov=mo*2*Math.atan(e),this.updateProjectionMatrix()}getFocalLength(){let t=Math.tan(co*.5*this.fov);return .5*this.getFilmHeight()/t}getEffectiveFOV(){return mo*2*Math.atan(Math.tan(co*.5*this.fov)/this.zoom)}getFilmWidth(){return this.filmGauge*Math.min(this.aspect,1)}getFilmHeight(){return this.filmGauge/Math.max(this.aspect,1)}getViewBounds(t,e,n){Ws.set(-1,-1,.5).applyMatrix4(this.projectionMatrixInverse),e.set(Ws.x,Ws.y).multiplyScalar(-t/Ws.z),Ws.set(1,1,.5).applyMatrix4(this.projectionMatrixInverse),n.set(Ws.x,Ws.y).multiplyScalar(-t/Ws.z)}getViewSize(t,e){return this.getViewBounds(t,zm,Vm),e.subVectors(Vm,zm)}setViewOffset(t,e,n,s,r,o){this.aspect=t/e,this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=t,this.view.fullHeight=e,this.view.offsetX=n,this.view.offsetY=s,this.view.width=r,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let t=this.near,e=t*Math.tan(co*.5*this.fov)/this.zoom,n=2*e,s=this.aspect*n,r=-.5*s,o=this.view;if(this.view!==null&&this.view.enabled){let l=o.fullWidth,c=o.fullHeight;r+=o.offsetX*s/l,e-=o.offsetY*n/c,s*=o.width/l,n*=o.height/c}let a=this.filmOffset;a!==0&&(r+=t*a/this.getFilmWidth()),this.projectionMatrix.makePerspective(r,r+s,e,e-n,t,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(t){let e=super.toJSON(t);return e.object.fov=this.fov,e.object.zoom=this.zoom,e.object.near=this.near,e.object.far=this.far,e.object.focus=this.focus,e.object.aspect=this.aspect,this.view!==null&&(e.object.view=Object.assign({},this.view)),e.object.filmGauge=this.filmGauge,e.object.filmOffset=this.filmOffset,e}};var La=class extends Ia{constructor(t=-1,e=1,n=1,s=-1,r=.1,o=2e3){super(),this.isOrthographicCamera=!0,this.type="OrthographicCamera",this.zoom=1,this.view=null,this.left=t,this.right=e,this.top=n,this.bottom=s,this.near=r,this.far=o,this.updateProjectionMatrix()}copy(t,e){return super.copy(t,e),this.left=t.left,this.right=t.right,this.top=t.top,this.bottom=t.bottom,this.near=t.near,this.far=t.far,this.zoom=t.zoom,this.view=t.view===null?null:Object.assign({},t.view),this}setViewOffset(t,e,n,s,r,o){this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=t,this.view.fullHeight=e,this.view.offsetX=n,this.view.offsetY=s,this.view.width=r,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let t=(this.right-this.left)/(2*this.zoom),e=(this.top-this.bottom)/(2*this.zoom),n=(this.right+this.left)/2,s=(this.top+this.bottom)/2,r=n-t,o=n+t,a=s+e,l=s-e;if(this.view!==null&&this.view.enabled){let c=(this.right-this.left)/this.view.fullWidth/this.zoom,f=(this.top-this.bottom)/this.view.fullHeight/this.zoom;r+=c*this.view.offsetX,o=r+c*this.view.width,a-=f*this.view.offsetY,l=a-f*this.view.height}this.projectionMatrix.makeOrthographic(r,o,a,l,this.near,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(t){let e=super.toJSON(t);return e.object.zoom=this.zoom,e.object.left=this.left,e.object.right=this.right,e.object.top=this.top,e.object.bottom=this.bottom,e.object.near=this.near,e.object.far=this.far,this.view!==null&&(e.object.view=Object.assign({},this.view)),e}},sf=class extends Hc{constructor(){super(new La(-5,5,5,-5,.5,500)),this.isDirectionalLightShadow=!0}},Da=class extends vo{constructor(t,e){super(t,e),this.isDirectionalLight=!0,this.type="DirectionalLight",this.position.copy(Fn.DEFAULT_UP),this.updateMatrix(),this.target=new Fn,this.shadow=new sf}dispose(){super.dispose(),this.shadow.dispose()}copy(t){return super.copy(t),this.target=t.target.clone(),this.shadow=t.shadow.clone(),this}toJSON(t){let e=super.toJSON(t);return e.object.shadow=this.shadow.toJSON(),e.object.target=this.target.uuid,e}},Na=class extends vo{constructor(t,e){super(t,e),this.isAmbientLight=!0,this.type="AmbientLight"}};var ao=-90,lo=1,So=class extends Fn{constructor(t,e,n){super(),this.type="CubeCamera",this.renderTarget=n,this.coordinateSystem=null,this.activeMipmapLevel=0;let s=new Kn(ao,lo,t,e);s.layers=this.layers,this.add(s);let r=new Kn(ao,lo,t,e);r.layers=this.layers,this.add(r);let o=new Kn(ao,lo,t,e);o.layers=this.layers,this.add(o);let a=new Kn(ao,lo,t,e);a.layers=this.layers,this.add(a);let l=new Kn(ao,lo,t,e);l.layers=this.layers,this.add(l);let c=new Kn(ao,lo,t,e);c.layers=this.layers,this.add(c)}updateCoordinateSystem(){let t=this.coordinateSystem,e=this.children.concat(),[n,s,r,o,a,l]=e;for(let c of e)this.remove(c);if(t===Ti)n.up.set(0,1,0),n.lookAt(1,0,0),s.up.set(0,1,0),s.lookAt(-1,0,0),r.up.set(0,0,-1),r.lookAt(0,1,0),o.up.set(0,0,1),o.lookAt(0,-1,0),a.up.set(0,1,0),a.lookAt(0,0,1),l.up.set(0,1,0),l.lookAt(0,0,-1);else if(t===fo)n.up.set(0,-1,0),n.lookAt(-1,0,0),s.up.set(0,-1,0),s.lookAt(1,0,0),r.up.set(0,0,1),r.lookAt(0,1,0),o.up.set(0,0,-1),o.lookAt(0,-1,0),a.up.set(0,-1,0),a.lookAt(0,0,1),l.up.set(0,-1,0),l.lookAt(0,0,-1);else throw new Error("THREE.CubeCamera.updateCoordinateSystem(): Invalid coordinate system: "+t);for(let c of e)this.add(c),c.updateMatrixWorld()}update(t,e){this.parent===null&&this.updateMatrixWorld();let{renderTarget:n,activeMipmapLevel:s}=this;this.coordinateSystem!==t.coordinateSystem&&(this.coordinateSystem=t.coordinateSystem,this.updateCoordinateSystem());let[r,o,a,l,c,f]=this.children,u=t.getRenderTarget(),h=t.getActiveCubeFace(),d=t.getActiveMipmapLevel(),p=t.xr.enabled;t.xr.enabled=!1;let _=n.texture.mipmapsAutoUpdate;n.texture.mipmapsAutoUpdate=!1;let g=!1;t.isWebGLRenderer===!0?g=t.state.buffers.depth.getReversed():g=t.reversedDepthBuffer,t.setRenderTarget(n,0,s),g&&t.autoClear===!1&&t.clearDepth(),t.render(e,r),t.setRenderTarget(n,1,s),g&&t.autoClear===!1&&t.clearDepth(),t.render(e,o),t.setRenderTarget(n,2,s),g&&t.autoClear===!1&&t.clearDepth(),t.render(e,a),t.setRenderTarget(n,3,s),g&&t.autoClear===!1&&t.clearDepth(),t.render(e,l),t.setRenderTarget(n,4,s),g&&t.autoClear===!1&&t.clearDepth(),t.render(e,c),n.texture.mipmapsAutoUpdate=_,t.setRenderTarget(n,5,s),g&&t.autoClear===!1&&t.clearDepth(),t.render(e,f),t.setRenderTarget(u,h,d),t.xr.enabled=p,n.texture.needsPMREMUpdate=!0}},Wc=class extends Kn{constructor(t=[]){super(),this.isArrayCamera=!0,this.isMultiViewCamera=!1,this.cameras=t,this.perCameraFrustumCulled=!1}};var zf="\\[\\]\\.:\\/",Hv=new RegExp("["+zf+"]","g"),Vf="[^"+zf+"]",Wv="[^"+zf.replace("\\.","")+"]",Xv=/((?:WC+[\/:])*)/.source.replace("WC",Vf),qv=/(WCOD+)?/.source.replace("WCOD",Wv),$v=/(?:\.(WC+)(?:\[(.+)\])?)?/.source.replace("WC",Vf),Yv=/\.(WC+)(?:\[(.+)\])?/.source.replace("WC",Vf),Zv=new RegExp("^"+Xv+qv+$v+Yv+"$"),Jv=["material","materials","bones","map"],rf=class{constructor(t,e,n){let s=n||Ze.parseTrackName(e);this._targetGroup=t,this._bindings=t.subscribe_(e,s)}getValue(t,e){this.bind();let n=this._targetGroup.nCachedObjects_,s=this._bindings[n];s!==void 0&&s.getValue(t,e)}setValue(t,e){let n=this._bindings;for(let s=this._targetGroup.nCachedObjects_,r=n.length;s!==r;++s)n[s].setValue(t,e)}bind(){let t=this._bindings;for(let e=this._targetGroup.nCachedObjects_,n=t.length;e!==n;++e)t[e].bind()}unbind(){let t=this._bindings;for(let e=this._targetGroup.nCachedObjects_,n=t.length;e!==n;++e)t[e].unbind()}},Ze=class i{constructor(t,e,n){this.path=e,this.parsedPath=n||i.parseTrackName(e),this.node=i.findNode(t,this.parsedPath.nodeName),this.rootNode=t,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}static create(t,e,n){return t&&t.isAnimationObjectGroup?new i.Composite(t,e,n):new i(t,e,n)}static sanitizeNodeName(t){return t.replace(/\s/g,"_").replace(Hv,"")}static parseTrackName(t){let e=Zv.exec(t);if(e===null)throw new Error("THREE.PropertyBinding: Cannot parse trackName: "+t);let n={nodeName:e[2],objectName:e[3],objectIndex:e[4],propertyName:e[5],propertyIndex:e[6]},s=n.nodeName&&n.nodeName.lastIndexOf(".");if(s!==void 0&&s!==-1){let r=n.nodeName.substring(s+1);Jv.indexOf(r)!==-1&&(n.nodeName=n.nodeName.substring(0,s),n.objectName=r)}if(n.propertyName===null||n.propertyName.length===0)throw new Error("THREE.PropertyBinding: can not parse propertyName from trackName: "+t);return n}static findNode(t,e){if(e===void 0||e===""||e==="."||e===-1||e===t.name||e===t.uuid)return t;if(t.skeleton){let n=t.skeleton.getBoneByName(e);if(n!==void 0)return n}if(t.children){let n=function(r){for(let o=0;o<r.length;o++){let a=r[o];if(a.name===e||a.uuid===e)return a;let l=n(a.children);if(l)return l}return null},s=n(t.children);if(s)return s}return null}_getValue_unavailable(){}_setValue_unavailable(){}_getValue_direct(t,e){t[e]=this.targetObject[this.propertyName]}_getValue_array(t,e){let n=this.resolvedProperty;for(let s=0,r=n.length;s!==r;++s)t[e++]=n[s]}_getValue_arrayElement(t,e){t[e]=this.resolvedProperty[this.propertyIndex]}_getValue_toArray(t,e){this.resolvedProperty.toArray(t,e)}_setValue_direct(t,e){this.targetObject[this.propertyName]=t[e]}_setValue_direct_setNeedsUpdate(t,e){this.targetObject[this.propertyName]=t[e],this.targetObject.needsUpdate=!0}_setValue_direct_setMatrixWorldNeedsUpdate(t,e){this.targetObject[this.propertyName]=t[e],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_array(t,e){let n=this.resolvedProperty;for(let s=0,r=n.length;s!==r;++s)n[s]=t[e++]}_setValue_array_setNeedsUpdate(t,e){let n=this.resolvedProperty;for(let s=0,r=n.length;s!==r;++s)n[s]=t[e++];this.targetObject.needsUpdate=!0}_setValue_array_setMatrixWorldNeedsUpdate(t,e){let n=this.resolvedProperty;for(let s=0,r=n.length;s!==r;++s)n[s]=t[e++];this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_arrayElement(t,e){this.resolvedProperty[this.propertyIndex]=t[e]}_setValue_arrayElement_setNeedsUpdate(t,e){this.resolvedProperty[this.propertyIndex]=t[e],this.targetObject.needsUpdate=!0}_setValue_arrayElement_setMatrixWorldNeedsUpdate(t,e){this.resolvedProperty[this.propertyIndex]=t[e],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_fromArray(t,e){this.resolvedProperty.fromArray(t,e)}_setValue_fromArray_setNeedsUpdate(t,e){this.resolvedProperty.fromArray(t,e),this.targetObject.needsUpdate=!0}_setValue_fromArray_setMatrixWorldNeedsUpdate(t,e){this.resolvedProperty.fromArray(t,e),this.targetObject.matrixWorldNeedsUpdate=!0}_getValue_unbound(t,e){this.bind(),this.getValue(t,e)}_setValue_unbound(t,e){this.bind(),this.setValue(t,e)}bind(){let t=this.node,e=this.parsedPath,n=e.objectName,s=e.propertyName,r=e.propertyIndex;if(t||(t=i.findNode(this.rootNode,e.nodeName),this.node=t),this.getValue=this._getValue_unavailable,this.setValue=this._setValue_unavailable,!t){jt("PropertyBinding: No target node found for track: "+this.path+".");return}if(n){let c=e.objectIndex;switch(n){case"materials":if(!t.material){se("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!t.material.materials){se("PropertyBinding: Can not bind to material.materials as node.material does not have a materials array.",this);return}t=t.material.materials;break;case"bones":if(!t.skeleton){se("PropertyBinding: Can not bind to bones as node does not have a skeleton.",this);return}t=t.skeleton.bones;for(let f=0;f<t.length;f++)if(t[f].name===c){c=f;break}break;case"map":if("map"in t){t=t.map;break}if(!t.material){se("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!t.material.map){se("PropertyBinding: Can not bind to material.map as node.material does not have a map.",this);return}t=t.material.map;break;default:if(t[n]===void 0){se("PropertyBinding: Can not bind to objectName of node undefined.",this);return}t=t[n]}if(c!==void 0){if(t[c]===void 0){se("PropertyBinding: Trying to bind to objectIndex of objectName, but is undefined.",this,t);return}t=t[c]}}let o=t[s];if(o===void 0){let c=e.nodeName;se("PropertyBinding: Trying to update property for track: "+c+"."+s+" but it wasn't found.",t);return}let a=this.Versioning.None;this.targetObject=t,t.isMaterial===!0?a=this.Versioning.NeedsUpdate:t.isObject3D===!0&&(a=this.Versioning.MatrixWorldNeedsUpdate);let l=this.BindingType.Direct;if(r!==void 0){if(s==="morphTargetInfluences"){if(!t.geometry){se("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.",this);return}if(!t.geometry.morphAttributes){se("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.morphAttributes.",this);return}t.morphTargetDictionary[r]!==void 0&&(r=t.morphTargetDictionary[r])}l=this.BindingType.ArrayElement,this.resolvedProperty=o,this.propertyIndex=r}else o.fromArray!==void 0&&o.toArray!==void 0?(l=this.BindingType.HasFromToArray,this.resolvedProperty=o):Array.isArray(o)?(l=this.BindingType.EntireArray,this.resolvedProperty=o):this.propertyName=s;this.getValue=this.GetterByBindingType[l],this.setValue=this.SetterByBindingTypeAndVersioning[l][a]}unbind(){this.node=null,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}};Ze.Composite=rf;Ze.prototype.BindingType={Direct:0,EntireArray:1,ArrayElement:2,HasFromToArray:3};Ze.prototype.Versioning={None:0,NeedsUpdate:1,MatrixWorldNeedsUpdate:2};Ze.prototype.GetterByBindingType=[Ze.prototype._getValue_direct,Ze.prototype._getValue_array,Ze.prototype._getValue_arrayElement,Ze.prototype._getValue_toArray];Ze.prototype.SetterByBindingTypeAndVersioning=[[Ze.prototype._setValue_direct,Ze.prototype._setValue_direct_setNeedsUpdate,Ze.prototype._setValue_direct_setMatrixWorldNeedsUpdate],[Ze.prototype._setValue_array,Ze.prototype._setValue_array_setNeedsUpdate,Ze.prototype._setValue_array_setMatrixWorldNeedsUpdate],[Ze.prototype._setValue_arrayElement,Ze.prototype._setValue_arrayElement_setNeedsUpdate,Ze.prototype._setValue_arrayElement_setMatrixWorldNeedsUpdate],[Ze.prototype._setValue_fromArray,Ze.prototype._setValue_fromArray_setNeedsUpdate,Ze.prototype._setValue_fromArray_setMatrixWorldNeedsUpdate]];var MI=new Float32Array(1);var Mo=class{constructor(t=1,e=0,n=0){this.radius=t,this.phi=e,this.theta=n}set(t,e,n){return this.radius=t,this.phi=e,this.theta=n,this}copy(t){return this.radius=t.radius,this.phi=t.phi,this.theta=t.theta,this}makeSafe(){return this.phi=ye(this.phi,1e-6,Math.PI-1e-6),this}setFromVector3(t){return this.setFromCartesianCoords(t.x,t.y,t.z)}setFromCartesianCoords(t,e,n){return this.radius=Math.sqrt(t*t+e*e+n*n),this.radius===0?(this.theta=0,this.phi=0):(this.theta=Math.atan2(t,n),this.phi=Math.acos(ye(e/this.radius,-1,1))),this}clone(){return new this.constructor().copy(this)}};var of=class{static{this.prototype.isMatrix2=!0}constructor(t,e,n,s){this.elements=[1,0,0,1],t!==void 0&&this.set(t,e,n,s)}identity(){return this.set(1,0,0,1),this}fromArray(t,e=0){for(let n=0;n<4;n++)this.elements[n]=t[n+e];return this}set(t,e,n,s){let r=this.elements;return r[0]=t,r[2]=e,r[1]=n,r[3]=s,this}};var Ua=class extends ss{constructor(t=10,e=10,n=4473924,s=8947848){n=new ue(n),s=new ue(s);let r=e/2,o=t/e,a=t/2,l=[],c=[];for(let h=0,d=0,p=-a;h<=e;h++,p+=o){l.push(-a,0,p,a,0,p),l.push(p,0,-a,p,0,a);let _=h===r?n:s;_.toArray(c,d),d+=3,_.toArray(c,d),d+=3,_.toArray(c,d),d+=3,_.toArray(c,d),d+=3}let f=new an;f.setAttribute("position",new Re(l,3)),f.setAttribute("color",new Re(c,3));let u=new Ei({vertexColors:!0,toneMapped:!1});super(f,u),this.type="GridHelper"}dispose(){super.dispose(),this.geometry.dispose(),this.material.dispose()}};var Fa=class extends Oi{constructor(t,e=null){super(),this.object=t,this.domElement=e,this.enabled=!0,this.state=-1,this.keys={},this.mouseButtons={LEFT:null,MIDDLE:null,RIGHT:null},this.touches={ONE:null,TWO:null}}connect(t){this.domElement!==null&&this.disconnect(),this.domElement=t}disconnect(){}dispose(){}update(){}};function Gf(i,t,e,n){let s=Kv(n);switch(e){case Ef:return i*t;case Cf:return i*t/s.components*s.byteLength;case Kc:return i*t/s.components*s.byteLength;case Qs:return i*t*2/s.components*s.byteLength;case jc:return i*t*2/s.components*s.byteLength;case Af:return i*t*3/s.components*s.byteLength;case Vi:return i*t*4/s.components*s.byteLength;case Qc:return i*t*4/s.components*s.byteLength;case ka:case za:return Math.floor((i+3)/4)*Math.floor((t+3)/4)*8;case Va:case Ga:return Math.floor((i+3)/4)*Math.floor((t+3)/4)*16;case eh:case ih:return Math.max(i,16)*Math.max(t,8)/4;case th:case nh:return Math.max(i,8)*Math.max(t,8)/2;case sh:case rh:case ah:case lh:return Math.floor((i+3)/4)*Math.floor((t+3)/4)*8;case oh:case Ha:case ch:return Math.floor((i+3)/4)*Math.floor((t+3)/4)*16;case hh:return Math.floor((i+3)/4)*Math.floor((t+3)/4)*16;case uh:return Math.floor((i+4)/5)*Math.floor((t+3)/4)*16;case fh:return Math.floor((i+4)/5)*Math.floor((t+4)/5)*16;case dh:return Math.floor((i+5)/6)*Math.floor((t+4)/5)*16;case ph:return Math.floor((i+5)/6)*Math.floor((t+5)/6)*16;case mh:return Math.floor((i+7)/8)*Math.floor((t+4)/5)*16;case gh:return Math.floor((i+7)/8)*Math.floor((t+5)/6)*16;case _h:return Math.floor((i+7)/8)*Math.floor((t+7)/8)*16;case xh:return Math.floor((i+9)/10)*Math.floor((t+4)/5)*16;case yh:return Math.floor((i+9)/10)*Math.floor((t+5)/6)*16;case vh:return Math.floor((i+9)/10)*Math.floor((t+7)/8)*16;case Sh:return Math.floor((i+9)/10)*Math.floor((t+9)/10)*16;case Mh:return Math.floor((i+11)/12)*Math.floor((t+9)/10)*16;case bh:return Math.floor((i+11)/12)*Math.floor((t+11)/12)*16;case wh:case Th:case Eh:return Math.ceil(i/4)*Math.ceil(t/4)*16;case Ah:case Ch:return Math.ceil(i/4)*Math.ceil(t/4)*8;case Wa:case Rh:return Math.ceil(i/4)*Math.ceil(t/4)*16}throw new Error(`Unable to determine texture byte length for ${e} format.`)}function Kv(i){switch(i){case ai:case Mf:return{byteLength:1,components:1};case Eo:case bf:case zi:return{byteLength:2,components:1};case Zc:case Jc:return{byteLength:2,components:4};case Bi:case Yc:case ki:return{byteLength:4,components:1};case wf:case Tf:return{byteLength:4,components:3}}throw new Error(`THREE.TextureUtils: Unknown texture type ${i}.`)}typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("register",{detail:{revision:"187"}}));typeof window<"u"&&(window.__THREE__?jt("WARNING: Multiple instances of Three.js being imported."):window.__THREE__="187");/**
 * @license
 * Copyright 2010-2026 Three.js Authors
 * SPDX-License-Identifier: MIT
 */function Jg(){let i=null,t=!1,e=null,n=null;function s(r,o){n=i.requestAnimationFrame(s),e(r,o)}return{start:function(){t!==!0&&e!==null&&i!==null&&(n=i.requestAnimationFrame(s),t=!0)},stop:function(){i!==null&&i.cancelAnimationFrame(n),t=!1},setAnimationLoop:function(r){e=r},setContext:function(r){i=r}}}function Qv(i){let t=new WeakMap;function e(a,l){let c=a.array,f=a.usage,u=c.byteLength,h=i.createBuffer();i.bindBuffer(l,h),i.bufferData(l,c,f),a.onUploadCallback();let d;if(c instanceof Float32Array)d=i.FLOAT;else if(typeof Float16Array<"u"&&c instanceof Float16Array)d=i.HALF_FLOAT;else if(c instanceof Uint16Array)a.isFloat16BufferAttribute?d=i.HALF_FLOAT:d=i.UNSIGNED_SHORT;else if(c instanceof Int16Array)d=i.SHORT;else if(c instanceof Uint32Array)d=i.UNSIGNED_INT;else if(c instanceof Int32Array)d=i.INT;else if(c instanceof Int8Array)d=i.BYTE;else if(c instanceof Uint8Array)d=i.UNSIGNED_BYTE;else if(c instanceof Uint8ClampedArray)d=i.UNSIGNED_BYTE;else throw new Error("THREE.WebGLAttributes: Unsupported buffer data format: "+c);return{buffer:h,type:d,bytesPerElement:c.BYTES_PER_ELEMENT,version:a.version,size:u}}function n(a,l,c){let f=l.array,u=l.updateRanges;if(i.bindBuffer(c,a),u.length===0)i.bufferSubData(c,0,f);else{u.sort((d,p)=>d.start-p.start);let h=0;for(let d=1;d<u.length;d++){let p=u[h],_=u[d];_.start<=p.start+p.count+1?p.count=Math.max(p.count,_.start+_.count-p.start):(++h,u[h]=_)}u.length=h+1;for(let d=0,p=u.length;d<p;d++){let _=u[d];i.bufferSubData(c,_.start*f.BYTES_PER_ELEMENT,f,_.start,_.count)}l.clearUpdateRanges()}l.onUploadCallback()}function s(a){return a.isInterleavedBufferAttribute&&(a=a.data),t.get(a)}function r(a){a.isInterleavedBufferAttribute&&(a=a.data);let l=t.get(a);l&&(i.deleteBuffer(l.buffer),t.delete(a))}function o(a,l){if(a.isInterleavedBufferAttribute&&(a=a.data),a.isGLBufferAttribute){let f=t.get(a);(!f||f.version<a.version)&&t.set(a,{buffer:a.buffer,type:a.type,bytesPerElement:a.elementSize,version:a.version});return}let c=t.get(a);if(c===void 0)t.set(a,e(a,l));else if(c.version<a.version){if(c.size!==a.array.byteLength)throw new Error("THREE.WebGLAttributes: The size of the buffer attribute's array buffer does not match the original size. Resizing buffer attributes is not supported.");n(c.buffer,a,l),c.version=a.version}}return{get:s,remove:r,update:o}}var tS=`#ifdef USE_ALPHAHASH
	if ( diffuseColor.a < getAlphaHashThreshold( vPosition ) ) discard;
#endif`,eS=`#ifdef USE_ALPHAHASH
	const float ALPHA_HASH_SCALE = 0.05;
	float hash2D( vec2 value ) {
		return fract( 1.0e4 * sin( 17.0 * value.x + 0.1 * value.y ) * ( 0.1 + abs( sin( 13.0 * value.y + value.x ) ) ) );
	}
	float hash3D( vec3 value ) {
		return hash2D( vec2( hash2D( value.xy ), value.z ) );
	}
	float getAlphaHashThreshold( vec3 position ) {
		float maxDeriv = max(
			length( dFdx( position.xyz ) ),
			length( dFdy( position.xyz ) )
		);
		float pixScale = 1.0 / ( ALPHA_HASH_SCALE * maxDeriv );
		vec2 pixScales = vec2(
			exp2( floor( log2( pixScale ) ) ),
			exp2( ceil( log2( pixScale ) ) )
		);
		vec2 alpha = vec2(
			hash3D( floor( pixScales.x * position.xyz ) ),
			hash3D( floor( pixScales.y * position.xyz ) )
		);
		float lerpFactor = fract( log2( pixScale ) );
		float x = ( 1.0 - lerpFactor ) * alpha.x + lerpFactor * alpha.y;
		float a = min( lerpFactor, 1.0 - lerpFactor );
		vec3 cases = vec3(
			x * x / ( 2.0 * a * ( 1.0 - a ) ),
			( x - 0.5 * a ) / ( 1.0 - a ),
			1.0 - ( ( 1.0 - x ) * ( 1.0 - x ) / ( 2.0 * a * ( 1.0 - a ) ) )
		);
		float threshold = ( x < ( 1.0 - a ) )
			? ( ( x < a ) ? cases.x : cases.y )
			: cases.z;
		return clamp( threshold , 1.0e-6, 1.0 );
	}
#endif`,nS=`#ifdef USE_ALPHAMAP
	diffuseColor.a *= texture2D( alphaMap, vAlphaMapUv ).g;
#endif`,iS=`#ifdef USE_ALPHAMAP
	uniform sampler2D alphaMap;
#endif`,sS=`#ifdef USE_ALPHATEST
	#ifdef ALPHA_TO_COVERAGE
	diffuseColor.a = smoothstep( alphaTest, alphaTest + fwidth( diffuseColor.a ), diffuseColor.a );
	if ( diffuseColor.a == 0.0 ) discard;
	#else
	if ( diffuseColor.a < alphaTest ) discard;
	#endif
#endif`,rS=`#ifdef USE_ALPHATEST
	uniform float alphaTest;
#endif`,oS=`#ifdef USE_AOMAP
	float ambientOcclusion = ( texture2D( aoMap, vAoMapUv ).r - 1.0 ) * aoMapIntensity + 1.0;
	reflectedLight.indirectDiffuse *= ambientOcclusion;
	#if defined( USE_CLEARCOAT ) 
		clearcoatSpecularIndirect *= ambientOcclusion;
	#endif
	#if defined( USE_SHEEN ) 
		sheenSpecularIndirect *= ambientOcclusion;
	#endif
	#if defined( USE_ENVMAP ) && defined( STANDARD )
		float dotNV = saturate( dot( geometryNormal, geometryViewDir ) );
		reflectedLight.indirectSpecular *= computeSpecularOcclusion( dotNV, ambientOcclusion, material.roughness );
	#endif
#endif`,aS=`#ifdef USE_AOMAP
	uniform sampler2D aoMap;
	uniform float aoMapIntensity;
#endif`,lS=`#ifdef USE_BATCHING
	#if ! defined( GL_ANGLE_multi_draw )
	#define gl_DrawID _gl_DrawID
	uniform int _gl_DrawID;
	#endif
	uniform highp sampler2D batchingTexture;
	uniform highp usampler2D batchingIdTexture;
	mat4 getBatchingMatrix( const in float i ) {
		int size = textureSize( batchingTexture, 0 ).x;
		int j = int( i ) * 4;
		int x = j % size;
		int y = j / size;
		vec4 v1 = texelFetch( batchingTexture, ivec2( x, y ), 0 );
		vec4 v2 = texelFetch( batchingTexture, ivec2( x + 1, y ), 0 );
		vec4 v3 = texelFetch( batchingTexture, ivec2( x + 2, y ), 0 );
		vec4 v4 = texelFetch( batchingTexture, ivec2( x + 3, y ), 0 );
		return mat4( v1, v2, v3, v4 );
	}
	float getIndirectIndex( const in int i ) {
		int size = textureSize( batchingIdTexture, 0 ).x;
		int x = i % size;
		int y = i / size;
		return float( texelFetch( batchingIdTexture, ivec2( x, y ), 0 ).r );
	}
#endif
#ifdef USE_BATCHING_COLOR
	uniform sampler2D batchingColorTexture;
	vec4 getBatchingColor( const in float i ) {
		int size = textureSize( batchingColorTexture, 0 ).x;
		int j = int( i );
		int x = j % size;
		int y = j / size;
		return texelFetch( batchingColorTexture, ivec2( x, y ), 0 );
	}
#endif`,cS=`#ifdef USE_BATCHING
	mat4 batchingMatrix = getBatchingMatrix( getIndirectIndex( gl_DrawID ) );
#endif`,hS=`vec3 transformed = vec3( position );
#ifdef USE_ALPHAHASH
	vPosition = vec3( position );
#endif`,uS=`vec3 objectNormal = vec3( normal );
#ifdef USE_TANGENT
	vec3 objectTangent = vec3( tangent.xyz );
#endif`,fS=`float G_BlinnPhong_Implicit( ) {
	return 0.25;
}
float D_BlinnPhong( const in float shininess, const in float dotNH ) {
	return RECIPROCAL_PI * ( shininess * 0.5 + 1.0 ) * pow( dotNH, shininess );
}
vec3 BRDF_BlinnPhong( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in vec3 specularColor, const in float shininess ) {
	vec3 halfDir = normalize( lightDir + viewDir );
	float dotNH = saturate( dot( normal, halfDir ) );
	float dotVH = saturate( dot( viewDir, halfDir ) );
	vec3 F = F_Schlick( specularColor, 1.0, dotVH );
	float G = G_BlinnPhong_Implicit( );
	float D = D_BlinnPhong( shininess, dotNH );
	return F * ( G * D );
} // validated`,dS=`#ifdef USE_IRIDESCENCE
	const mat3 XYZ_TO_REC709 = mat3(
		 3.2404542, -0.9692660,  0.0556434,
		-1.5371385,  1.8760108, -0.2040259,
		-0.4985314,  0.0415560,  1.0572252
	);
	vec3 Fresnel0ToIor( vec3 fresnel0 ) {
		vec3 sqrtF0 = sqrt( fresnel0 );
		return ( vec3( 1.0 ) + sqrtF0 ) / ( vec3( 1.0 ) - sqrtF0 );
	}
	vec3 IorToFresnel0( vec3 transmittedIor, float incidentIor ) {
		return pow2( ( transmittedIor - vec3( incidentIor ) ) / ( transmittedIor + vec3( incidentIor ) ) );
	}
	float IorToFresnel0( float transmittedIor, float incidentIor ) {
		return pow2( ( transmittedIor - incidentIor ) / ( transmittedIor + incidentIor ));
	}
	vec3 evalSensitivity( float OPD, vec3 shift ) {
		float phase = 2.0 * PI * OPD * 1.0e-9;
		vec3 val = vec3( 5.4856e-13, 4.4201e-13, 5.2481e-13 );
		vec3 pos = vec3( 1.6810e+06, 1.7953e+06, 2.2084e+06 );
		vec3 var = vec3( 4.3278e+09, 9.3046e+09, 6.6121e+09 );
		vec3 xyz = val * sqrt( 2.0 * PI * var ) * cos( pos * phase + shift ) * exp( - pow2( phase ) * var );
		xyz.x += 9.7470e-14 * sqrt( 2.0 * PI * 4.5282e+09 ) * cos( 2.2399e+06 * phase + shift[ 0 ] ) * exp( - 4.5282e+09 * pow2( phase ) );
		xyz /= 1.0685e-7;
		vec3 rgb = XYZ_TO_REC709 * xyz;
		return rgb;
	}
	vec3 evalIridescence( float outsideIOR, float eta2, float cosTheta1, float thinFilmThickness, vec3 baseF0 ) {
		vec3 I;
		float iridescenceIOR = mix( outsideIOR, eta2, smoothstep( 0.0, 0.03, thinFilmThickness ) );
		float sinTheta2Sq = pow2( outsideIOR / iridescenceIOR ) * ( 1.0 - pow2( cosTheta1 ) );
		float cosTheta2Sq = 1.0 - sinTheta2Sq;
		if ( cosTheta2Sq < 0.0 ) {
			return vec3( 1.0 );
		}
		float cosTheta2 = sqrt( cosTheta2Sq );
		float R0 = IorToFresnel0( iridescenceIOR, outsideIOR );
		float R12 = F_Schlick( R0, 1.0, cosTheta1 );
		float T121 = 1.0 - R12;
		float phi12 = 0.0;
		if ( iridescenceIOR < outsideIOR ) phi12 = PI;
		float phi21 = PI - phi12;
		vec3 baseIOR = Fresnel0ToIor( clamp( baseF0, 0.0, 0.9999 ) );		vec3 R1 = IorToFresnel0( baseIOR, iridescenceIOR );
		vec3 R23 = F_Schlick( R1, 1.0, cosTheta2 );
		vec3 phi23 = vec3( 0.0 );
		if ( baseIOR[ 0 ] < iridescenceIOR ) phi23[ 0 ] = PI;
		if ( baseIOR[ 1 ] < iridescenceIOR ) phi23[ 1 ] = PI;
		if ( baseIOR[ 2 ] < iridescenceIOR ) phi23[ 2 ] = PI;
		float OPD = 2.0 * iridescenceIOR * thinFilmThickness * cosTheta2;
		vec3 phi = vec3( phi21 ) + phi23;
		vec3 R123 = clamp( R12 * R23, 1e-5, 0.9999 );
		vec3 r123 = sqrt( R123 );
		vec3 Rs = pow2( T121 ) * R23 / ( vec3( 1.0 ) - R123 );
		vec3 C0 = R12 + Rs;
		I = C0;
		vec3 Cm = Rs - T121;
		for ( int m = 1; m <= 2; ++ m ) {
			Cm *= r123;
			vec3 Sm = 2.0 * evalSensitivity( float( m ) * OPD, float( m ) * phi );
			I += Cm * Sm;
		}
		return max( I, vec3( 0.0 ) );
	}
#endif`,pS=`#ifdef USE_BUMPMAP
	uniform sampler2D bumpMap;
	uniform float bumpScale;
	vec2 dHdxy_fwd() {
		vec2 dSTdx = dFdx( vBumpMapUv );
		vec2 dSTdy = dFdy( vBumpMapUv );
		float Hll = bumpScale * texture2D( bumpMap, vBumpMapUv ).x;
		float dBx = bumpScale * texture2D( bumpMap, vBumpMapUv + dSTdx ).x - Hll;
		float dBy = bumpScale * texture2D( bumpMap, vBumpMapUv + dSTdy ).x - Hll;
		return vec2( dBx, dBy );
	}
	vec3 perturbNormalArb( vec3 surf_pos, vec3 surf_norm, vec2 dHdxy, float faceDirection ) {
		vec3 vSigmaX = normalize( dFdx( surf_pos.xyz ) );
		vec3 vSigmaY = normalize( dFdy( surf_pos.xyz ) );
		vec3 vN = surf_norm;
		vec3 R1 = cross( vSigmaY, vN );
		vec3 R2 = cross( vN, vSigmaX );
		float fDet = dot( vSigmaX, R1 ) * faceDirection;
		vec3 vGrad = sign( fDet ) * ( dHdxy.x * R1 + dHdxy.y * R2 );
		return normalize( abs( fDet ) * surf_norm - vGrad );
	}
#endif`,mS=`#if NUM_CLIPPING_PLANES > 0
	vec4 plane;
	#ifdef ALPHA_TO_COVERAGE
		float distanceToPlane, distanceGradient;
		float clipOpacity = 1.0;
		#pragma unroll_loop_start
		for ( int i = 0; i < UNION_CLIPPING_PLANES; i ++ ) {
			plane = clippingPlanes[ i ];
			distanceToPlane = - dot( vClipPosition, plane.xyz ) + plane.w;
			distanceGradient = fwidth( distanceToPlane ) / 2.0;
			clipOpacity *= smoothstep( - distanceGradient, distanceGradient, distanceToPlane );
			if ( clipOpacity == 0.0 ) discard;
		}
		#pragma unroll_loop_end
		#if UNION_CLIPPING_PLANES < NUM_CLIPPING_PLANES
			float unionClipOpacity = 1.0;
			#pragma unroll_loop_start
			for ( int i = UNION_CLIPPING_PLANES; i < NUM_CLIPPING_PLANES; i ++ ) {
				plane = clippingPlanes[ i ];
				distanceToPlane = - dot( vClipPosition, plane.xyz ) + plane.w;
				distanceGradient = fwidth( distanceToPlane ) / 2.0;
				unionClipOpacity *= 1.0 - smoothstep( - distanceGradient, distanceGradient, distanceToPlane );
			}
			#pragma unroll_loop_end
			clipOpacity *= 1.0 - unionClipOpacity;
		#endif
		diffuseColor.a *= clipOpacity;
		if ( diffuseColor.a == 0.0 ) discard;
	#else
		#pragma unroll_loop_start
		for ( int i = 0; i < UNION_CLIPPING_PLANES; i ++ ) {
			plane = clippingPlanes[ i ];
			if ( dot( vClipPosition, plane.xyz ) > plane.w ) discard;
		}
		#pragma unroll_loop_end
		#if UNION_CLIPPING_PLANES < NUM_CLIPPING_PLANES
			bool clipped = true;
			#pragma unroll_loop_start
			for ( int i = UNION_CLIPPING_PLANES; i < NUM_CLIPPING_PLANES; i ++ ) {
				plane = clippingPlanes[ i ];
				clipped = ( dot( vClipPosition, plane.xyz ) > plane.w ) && clipped;
			}
			#pragma unroll_loop_end
			if ( clipped ) discard;
		#endif
	#endif
#endif`,gS=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
	uniform vec4 clippingPlanes[ NUM_CLIPPING_PLANES ];
#endif`,_S=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
#endif`,xS=`#if NUM_CLIPPING_PLANES > 0
	vClipPosition = - mvPosition.xyz;
#endif`,yS=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	diffuseColor *= vColor;
#endif`,vS=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	varying vec4 vColor;
#endif`,SS=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
	varying vec4 vColor;
#endif`,MS=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
	vColor = vec4( 1.0 );
#endif
#ifdef USE_COLOR_ALPHA
	vColor *= color;
#elif defined( USE_COLOR )
	vColor.rgb *= color;
#endif
#ifdef USE_INSTANCING_COLOR
	vColor.rgb *= instanceColor.rgb;
#endif
#ifdef USE_BATCHING_COLOR
	vColor *= getBatchingColor( getIndirectIndex( gl_DrawID ) );
#endif`,bS=`#define PI 3.141592653589793
#define PI2 6.283185307179586
#define PI_HALF 1.5707963267948966
#define RECIPROCAL_PI 0.3183098861837907
#define RECIPROCAL_PI2 0.15915494309189535
#define EPSILON 1e-6
#ifndef saturate
#define saturate( a ) clamp( a, 0.0, 1.0 )
#endif
#define whiteComplement( a ) ( 1.0 - saturate( a ) )
float pow2( const in float x ) { return x*x; }
vec3 pow2( const in vec3 x ) { return x*x; }
float pow3( const in float x ) { return x*x*x; }
float pow4( const in float x ) { float x2 = x*x; return x2*x2; }
float max3( const in vec3 v ) { return max( max( v.x, v.y ), v.z ); }
float average( const in vec3 v ) { return dot( v, vec3( 0.3333333 ) ); }
highp float rand( const in vec2 uv ) {
	const highp float a = 12.9898, b = 78.233, c = 43758.5453;
	highp float dt = dot( uv.xy, vec2( a,b ) ), sn = mod( dt, PI );
	return fract( sin( sn ) * c );
}
#ifdef HIGH_PRECISION
	float precisionSafeLength( vec3 v ) { return length( v ); }
#else
	float precisionSafeLength( vec3 v ) {
		float maxComponent = max3( abs( v ) );
		return length( v / maxComponent ) * maxComponent;
	}
#endif
struct IncidentLight {
	vec3 color;
	vec3 direction;
	bool visible;
};
struct ReflectedLight {
	vec3 directDiffuse;
	vec3 directSpecular;
	vec3 indirectDiffuse;
	vec3 indirectSpecular;
};
#ifdef USE_ALPHAHASH
	varying vec3 vPosition;
#endif
vec3 transformDirection( in vec3 dir, in mat4 matrix ) {
	return normalize( ( matrix * vec4( dir, 0.0 ) ).xyz );
}
#define inverseTransformDirection transformDirectionByInverseViewMatrix
vec3 transformNormalByInverseViewMatrix( in vec3 normal, in mat4 viewMatrix ) {
	return normalize( ( vec4( normal, 0.0 ) * viewMatrix ).xyz );
}
vec3 transformDirectionByInverseViewMatrix( in vec3 dir, in mat4 viewMatrix ) {
	return normalize( ( vec4( dir, 0.0 ) * viewMatrix ).xyz );
}
bool isPerspectiveMatrix( mat4 m ) {
	return m[ 2 ][ 3 ] == - 1.0;
}
vec2 equirectUv( in vec3 dir ) {
	float u = atan( dir.z, dir.x ) * RECIPROCAL_PI2 + 0.5;
	float v = asin( clamp( dir.y, - 1.0, 1.0 ) ) * RECIPROCAL_PI + 0.5;
	return vec2( u, v );
}
vec3 BRDF_Lambert( const in vec3 diffuseColor ) {
	return RECIPROCAL_PI * diffuseColor;
}
vec3 F_Schlick( const in vec3 f0, const in float f90, const in float dotVH ) {
	float fresnel = exp2( ( - 5.55473 * dotVH - 6.98316 ) * dotVH );
	return f0 * ( 1.0 - fresnel ) + ( f90 * fresnel );
}
float F_Schlick( const in float f0, const in float f90, const in float dotVH ) {
	float fresnel = exp2( ( - 5.55473 * dotVH - 6.98316 ) * dotVH );
	return f0 * ( 1.0 - fresnel ) + ( f90 * fresnel );
} // validated`,wS=`vec3 transformedNormal = objectNormal;
#ifdef USE_TANGENT
	vec3 transformedTangent = objectTangent;
#endif
#ifdef USE_BATCHING
	mat3 bm = mat3( batchingMatrix );
	transformedNormal /= vec3( dot( bm[ 0 ], bm[ 0 ] ), dot( bm[ 1 ], bm[ 1 ] ), dot( bm[ 2 ], bm[ 2 ] ) );
	transformedNormal = bm * transformedNormal;
	#ifdef USE_TANGENT
		transformedTangent = bm * transformedTangent;
	#endif
#endif
#ifdef USE_INSTANCING
	mat3 im = mat3( instanceMatrix );
	transformedNormal /= vec3( dot( im[ 0 ], im[ 0 ] ), dot( im[ 1 ], im[ 1 ] ), dot( im[ 2 ], im[ 2 ] ) );
	transformedNormal = im * transformedNormal;
	#ifdef USE_TANGENT
		transformedTangent = im * transformedTangent;
	#endif
#endif
transformedNormal = normalMatrix * transformedNormal;
#ifdef FLIP_SIDED
	transformedNormal = - transformedNormal;
#endif
#ifdef USE_TANGENT
	transformedTangent = ( modelViewMatrix * vec4( transformedTangent, 0.0 ) ).xyz;
#endif`,TS=`#ifdef USE_DISPLACEMENTMAP
	uniform sampler2D displacementMap;
	uniform float displacementScale;
	uniform float displacementBias;
#endif`,ES=`#ifdef USE_DISPLACEMENTMAP
	transformed += normalize( objectNormal ) * ( texture2D( displacementMap, vDisplacementMapUv ).x * displacementScale + displacementBias );
#endif`,AS=`#ifdef USE_EMISSIVEMAP
	vec4 emissiveColor = texture2D( emissiveMap, vEmissiveMapUv );
	#ifdef DECODE_VIDEO_TEXTURE_EMISSIVE
		emissiveColor = sRGBTransferEOTF( emissiveColor );
	#endif
	totalEmissiveRadiance *= emissiveColor.rgb;
#endif`,CS=`#ifdef USE_EMISSIVEMAP
	uniform sampler2D emissiveMap;
#endif`,RS="gl_FragColor = linearToOutputTexel( gl_FragColor );",PS=`vec4 LinearTransferOETF( in vec4 value ) {
	return value;
}
vec4 sRGBTransferEOTF( in vec4 value ) {
	return vec4( mix( pow( value.rgb * 0.9478672986 + vec3( 0.0521327014 ), vec3( 2.4 ) ), value.rgb * 0.0773993808, vec3( lessThanEqual( value.rgb, vec3( 0.04045 ) ) ) ), value.a );
}
vec4 sRGBTransferOETF( in vec4 value ) {
	return vec4( mix( pow( value.rgb, vec3( 0.41666 ) ) * 1.055 - vec3( 0.055 ), value.rgb * 12.92, vec3( lessThanEqual( value.rgb, vec3( 0.0031308 ) ) ) ), value.a );
}`,IS=`#ifdef USE_ENVMAP
	#ifdef ENV_WORLDPOS
		vec3 cameraToFrag;
		if ( isOrthographic ) {
			cameraToFrag = normalize( vec3( - viewMatrix[ 0 ][ 2 ], - viewMatrix[ 1 ][ 2 ], - viewMatrix[ 2 ][ 2 ] ) );
		} else {
			cameraToFrag = normalize( vWorldPosition - cameraPosition );
		}
		vec3 worldNormal = transformNormalByInverseViewMatrix( normal, viewMatrix );
		#ifdef ENVMAP_MODE_REFLECTION
			vec3 reflectVec = reflect( cameraToFrag, worldNormal );
		#else
			vec3 reflectVec = refract( cameraToFrag, worldNormal, refractionRatio );
		#endif
	#else
		vec3 reflectVec = vReflect;
	#endif
	#ifdef ENVMAP_TYPE_CUBE
		vec4 envColor = textureCube( envMap, envMapRotation * reflectVec );
		#ifdef ENVMAP_BLENDING_MULTIPLY
			outgoingLight = mix( outgoingLight, outgoingLight * envColor.xyz, specularStrength * reflectivity );
		#elif defined( ENVMAP_BLENDING_MIX )
			outgoingLight = mix( outgoingLight, envColor.xyz, specularStrength * reflectivity );
		#elif defined( ENVMAP_BLENDING_ADD )
			outgoingLight += envColor.xyz * specularStrength * reflectivity;
		#endif
	#endif
#endif`,LS=`#ifdef USE_ENVMAP
	uniform float envMapIntensity;
	uniform mat3 envMapRotation;
	uniform samplerCube envMap;
	#ifdef ENVMAP_TYPE_PMREM
		float roughnessToMip( const in float roughness ) {
			float r = clamp( roughness, 0.0, 1.0 );
			return ENVMAP_MAX_LOD * r * ( 2.0 - r );
		}
	#endif
#endif`,DS=`#ifdef USE_ENVMAP
	uniform float reflectivity;
	#if defined( USE_BUMPMAP ) || defined( USE_NORMALMAP ) || defined( PHONG ) || defined( LAMBERT )
		#define ENV_WORLDPOS
	#endif
	#ifdef ENV_WORLDPOS
		varying vec3 vWorldPosition;
		uniform float refractionRatio;
	#else
		varying vec3 vReflect;
	#endif
#endif`,NS=`#ifdef USE_ENVMAP
	#if defined( USE_BUMPMAP ) || defined( USE_NORMALMAP ) || defined( PHONG ) || defined( LAMBERT )
		#define ENV_WORLDPOS
	#endif
	#ifdef ENV_WORLDPOS
		
		varying vec3 vWorldPosition;
	#else
		varying vec3 vReflect;
		uniform float refractionRatio;
	#endif
#endif`,US=`#ifdef USE_ENVMAP
	#ifdef ENV_WORLDPOS
		vWorldPosition = worldPosition.xyz;
	#else
		vec3 cameraToVertex;
		if ( isOrthographic ) {
			cameraToVertex = normalize( vec3( - viewMatrix[ 0 ][ 2 ], - viewMatrix[ 1 ][ 2 ], - viewMatrix[ 2 ][ 2 ] ) );
		} else {
			cameraToVertex = normalize( worldPosition.xyz - cameraPosition );
		}
		vec3 worldNormal = transformNormalByInverseViewMatrix( transformedNormal, viewMatrix );
		#ifdef ENVMAP_MODE_REFLECTION
			vReflect = reflect( cameraToVertex, worldNormal );
		#else
			vReflect = refract( cameraToVertex, worldNormal, refractionRatio );
		#endif
	#endif
#endif`,FS=`#ifdef USE_FOG
	vFogDepth = - mvPosition.z;
#endif`,OS=`#ifdef USE_FOG
	varying float vFogDepth;
#endif`,BS=`#ifdef USE_FOG
	#ifdef FOG_EXP2
		float fogFactor = 1.0 - exp( - fogDensity * fogDensity * vFogDepth * vFogDepth );
	#else
		float fogFactor = smoothstep( fogNear, fogFar, vFogDepth );
	#endif
	gl_FragColor.rgb = mix( gl_FragColor.rgb, fogColor, fogFactor );
#endif`,kS=`#ifdef USE_FOG
	uniform vec3 fogColor;
	varying float vFogDepth;
	#ifdef FOG_EXP2
		uniform float fogDensity;
	#else
		uniform float fogNear;
		uniform float fogFar;
	#endif
#endif`,zS=`#ifdef USE_GRADIENTMAP
	uniform sampler2D gradientMap;
#endif
vec3 getGradientIrradiance( vec3 normal, vec3 lightDirection ) {
	float dotNL = dot( normal, lightDirection );
	vec2 coord = vec2( dotNL * 0.5 + 0.5, 0.0 );
	#ifdef USE_GRADIENTMAP
		return vec3( texture2D( gradientMap, coord ).r );
	#else
		vec2 fw = fwidth( coord ) * 0.5;
		return mix( vec3( 0.7 ), vec3( 1.0 ), smoothstep( 0.7 - fw.x, 0.7 + fw.x, coord.x ) );
	#endif
}`,VS=`#ifdef USE_LIGHTMAP
	uniform sampler2D lightMap;
	uniform float lightMapIntensity;
#endif`,GS=`LambertMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularStrength = specularStrength;`,HS=`varying vec3 vViewPosition;
struct LambertMaterial {
	vec3 diffuseColor;
	float specularStrength;
};
void RE_Direct_Lambert( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in LambertMaterial material, inout ReflectedLight reflectedLight ) {
	float dotNL = saturate( dot( geometryNormal, directLight.direction ) );
	vec3 irradiance = dotNL * directLight.color;
	reflectedLight.directDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
void RE_IndirectDiffuse_Lambert( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in LambertMaterial material, inout ReflectedLight reflectedLight ) {
	reflectedLight.indirectDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
#define RE_Direct				RE_Direct_Lambert
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Lambert`,WS=`uniform bool receiveShadow;
uniform vec3 ambientLightColor;
#if defined( USE_LIGHT_PROBES )
	uniform vec3 lightProbe[ 9 ];
#endif
vec3 shGetIrradianceAt( in vec3 normal, in vec3 shCoefficients[ 9 ] ) {
	float x = normal.x, y = normal.y, z = normal.z;
	vec3 result = shCoefficients[ 0 ] * 0.886227;
	result += shCoefficients[ 1 ] * 2.0 * 0.511664 * y;
	result += shCoefficients[ 2 ] * 2.0 * 0.511664 * z;
	result += shCoefficients[ 3 ] * 2.0 * 0.511664 * x;
	result += shCoefficients[ 4 ] * 2.0 * 0.429043 * x * y;
	result += shCoefficients[ 5 ] * 2.0 * 0.429043 * y * z;
	result += shCoefficients[ 6 ] * ( 0.743125 * z * z - 0.247708 );
	result += shCoefficients[ 7 ] * 2.0 * 0.429043 * x * z;
	result += shCoefficients[ 8 ] * 0.429043 * ( x * x - y * y );
	return result;
}
vec3 getLightProbeIrradiance( const in vec3 lightProbe[ 9 ], const in vec3 normal ) {
	vec3 worldNormal = transformNormalByInverseViewMatrix( normal, viewMatrix );
	vec3 irradiance = shGetIrradianceAt( worldNormal, lightProbe );
	return irradiance;
}
vec3 getAmbientLightIrradiance( const in vec3 ambientLightColor ) {
	vec3 irradiance = ambientLightColor;
	return irradiance;
}
float getDistanceAttenuation( const in float lightDistance, const in float cutoffDistance, const in float decayExponent ) {
	float distanceFalloff = 1.0 / max( pow( lightDistance, decayExponent ), 0.01 );
	if ( cutoffDistance > 0.0 ) {
		distanceFalloff *= pow2( saturate( 1.0 - pow4( lightDistance / cutoffDistance ) ) );
	}
	return distanceFalloff;
}
float getSpotAttenuation( const in float coneCosine, const in float penumbraCosine, const in float angleCosine ) {
	return smoothstep( coneCosine, penumbraCosine, angleCosine );
}
#if NUM_SUN_LIGHTS > 0
	struct SunLight {
		vec3 direction;
		vec3 color;
	};
	uniform SunLight sunLights[ NUM_SUN_LIGHTS ];
	void getSunLightInfo( const in SunLight sunLight, out IncidentLight light ) {
		light.color = sunLight.color;
		light.direction = sunLight.direction;
		light.visible = true;
	}
#endif
#if NUM_DIR_LIGHTS > 0
	struct DirectionalLight {
		vec3 direction;
		vec3 color;
	};
	uniform DirectionalLight directionalLights[ NUM_DIR_LIGHTS ];
	void getDirectionalLightInfo( const in DirectionalLight directionalLight, out IncidentLight light ) {
		light.color = directionalLight.color;
		light.direction = directionalLight.direction;
		light.visible = true;
	}
#endif
#if NUM_POINT_LIGHTS > 0
	struct PointLight {
		vec3 position;
		vec3 color;
		float distance;
		float decay;
	};
	uniform PointLight pointLights[ NUM_POINT_LIGHTS ];
	void getPointLightInfo( const in PointLight pointLight, const in vec3 geometryPosition, out IncidentLight light ) {
		vec3 lVector = pointLight.position - geometryPosition;
		light.direction = normalize( lVector );
		float lightDistance = length( lVector );
		light.color = pointLight.color;
		light.color *= getDistanceAttenuation( lightDistance, pointLight.distance, pointLight.decay );
		light.visible = ( light.color != vec3( 0.0 ) );
	}
#endif
#if NUM_SPOT_LIGHTS > 0
	struct SpotLight {
		vec3 position;
		vec3 direction;
		vec3 color;
		float distance;
		float decay;
		float coneCos;
		float penumbraCos;
	};
	uniform SpotLight spotLights[ NUM_SPOT_LIGHTS ];
	void getSpotLightInfo( const in SpotLight spotLight, const in vec3 geometryPosition, out IncidentLight light ) {
		vec3 lVector = spotLight.position - geometryPosition;
		light.direction = normalize( lVector );
		float angleCos = dot( light.direction, spotLight.direction );
		float spotAttenuation = getSpotAttenuation( spotLight.coneCos, spotLight.penumbraCos, angleCos );
		if ( spotAttenuation > 0.0 ) {
			float lightDistance = length( lVector );
			light.color = spotLight.color * spotAttenuation;
			light.color *= getDistanceAttenuation( lightDistance, spotLight.distance, spotLight.decay );
			light.visible = ( light.color != vec3( 0.0 ) );
		} else {
			light.color = vec3( 0.0 );
			light.visible = false;
		}
	}
#endif
#if NUM_RECT_AREA_LIGHTS > 0
	struct RectAreaLight {
		vec3 color;
		vec3 position;
		vec3 halfWidth;
		vec3 halfHeight;
	};
	uniform sampler2D ltc_1;	uniform sampler2D ltc_2;
	uniform RectAreaLight rectAreaLights[ NUM_RECT_AREA_LIGHTS ];
#endif
#if NUM_HEMI_LIGHTS > 0
	struct HemisphereLight {
		vec3 direction;
		vec3 skyColor;
		vec3 groundColor;
	};
	uniform HemisphereLight hemisphereLights[ NUM_HEMI_LIGHTS ];
	vec3 getHemisphereLightIrradiance( const in HemisphereLight hemiLight, const in vec3 normal ) {
		float dotNL = dot( normal, hemiLight.direction );
		float hemiDiffuseWeight = 0.5 * dotNL + 0.5;
		vec3 irradiance = mix( hemiLight.groundColor, hemiLight.skyColor, hemiDiffuseWeight );
		return irradiance;
	}
#endif
#include <lightprobes_pars_fragment>`,XS=`#ifdef USE_ENVMAP
	vec3 getIBLIrradiance( const in vec3 normal ) {
		#ifdef ENVMAP_TYPE_PMREM
			vec3 worldNormal = transformNormalByInverseViewMatrix( normal, viewMatrix );
			vec4 envMapColor = textureLod( envMap, envMapRotation * worldNormal, ENVMAP_MAX_LOD );
			return PI * envMapColor.rgb * envMapIntensity;
		#else
			return vec3( 0.0 );
		#endif
	}
	vec3 getIBLRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness ) {
		#ifdef ENVMAP_TYPE_PMREM
			vec3 reflectVec = reflect( - viewDir, normal );
			reflectVec = normalize( mix( reflectVec, normal, pow4( roughness ) ) );
			reflectVec = transformDirectionByInverseViewMatrix( reflectVec, viewMatrix );
			vec4 envMapColor = textureLod( envMap, envMapRotation * reflectVec, roughnessToMip( roughness ) );
			return envMapColor.rgb * envMapIntensity;
		#else
			return vec3( 0.0 );
		#endif
	}
	#ifdef USE_RETROREFLECTION
		vec3 getIBLRetroRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness ) {
			#ifdef ENVMAP_TYPE_PMREM
				vec3 retroVec = normalize( mix( viewDir, normal, pow4( roughness ) ) );
				retroVec = transformDirectionByInverseViewMatrix( retroVec, viewMatrix );
				vec4 envMapColor = textureLod( envMap, envMapRotation * retroVec, roughnessToMip( roughness ) );
				return envMapColor.rgb * envMapIntensity;
			#else
				return vec3( 0.0 );
			#endif
		}
	#endif
	#ifdef USE_ANISOTROPY
		vec3 getIBLAnisotropyRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness, const in vec3 bitangent, const in float anisotropy ) {
			#ifdef ENVMAP_TYPE_PMREM
				vec3 bentNormal = cross( bitangent, viewDir );
				bentNormal = normalize( cross( bentNormal, bitangent ) );
				bentNormal = normalize( mix( bentNormal, normal, pow2( pow2( 1.0 - anisotropy * ( 1.0 - roughness ) ) ) ) );
				return getIBLRadiance( viewDir, bentNormal, roughness );
			#else
				return vec3( 0.0 );
			#endif
		}
		#ifdef USE_RETROREFLECTION
			vec3 getIBLAnisotropyRetroRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness, const in vec3 bitangent, const in float anisotropy ) {
				#ifdef ENVMAP_TYPE_PMREM
					vec3 bentNormal = cross( bitangent, viewDir );
					bentNormal = normalize( cross( bentNormal, bitangent ) );
					bentNormal = normalize( mix( bentNormal, normal, pow2( pow2( 1.0 - anisotropy * ( 1.0 - roughness ) ) ) ) );
					return getIBLRetroRadiance( viewDir, bentNormal, roughness );
				#else
					return vec3( 0.0 );
				#endif
			}
		#endif
	#endif
#endif`,qS=`ToonMaterial material;
material.diffuseColor = diffuseColor.rgb;`,$S=`varying vec3 vViewPosition;
struct ToonMaterial {
	vec3 diffuseColor;
};
void RE_Direct_Toon( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in ToonMaterial material, inout ReflectedLight reflectedLight ) {
	vec3 irradiance = getGradientIrradiance( geometryNormal, directLight.direction ) * directLight.color;
	reflectedLight.directDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
void RE_IndirectDiffuse_Toon( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in ToonMaterial material, inout ReflectedLight reflectedLight ) {
	reflectedLight.indirectDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
#define RE_Direct				RE_Direct_Toon
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Toon`,YS=`BlinnPhongMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularColor = specular;
material.specularShininess = shininess;
material.specularStrength = specularStrength;`,ZS=`varying vec3 vViewPosition;
struct BlinnPhongMaterial {
	vec3 diffuseColor;
	vec3 specularColor;
	float specularShininess;
	float specularStrength;
};
void RE_Direct_BlinnPhong( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in BlinnPhongMaterial material, inout ReflectedLight reflectedLight ) {
	float dotNL = saturate( dot( geometryNormal, directLight.direction ) );
	vec3 irradiance = dotNL * directLight.color;
	reflectedLight.directDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
	reflectedLight.directSpecular += irradiance * BRDF_BlinnPhong( directLight.direction, geometryViewDir, geometryNormal, material.specularColor, material.specularShininess ) * material.specularStrength;
}
void RE_IndirectDiffuse_BlinnPhong( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in BlinnPhongMaterial material, inout ReflectedLight reflectedLight ) {
	reflectedLight.indirectDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
#define RE_Direct				RE_Direct_BlinnPhong
#define RE_IndirectDiffuse		RE_IndirectDiffuse_BlinnPhong`,JS=`PhysicalMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.diffuseContribution = diffuseColor.rgb * ( 1.0 - metalnessFactor );
material.metalness = metalnessFactor;
vec3 dxy = max( abs( dFdx( nonPerturbedNormal ) ), abs( dFdy( nonPerturbedNormal ) ) );
float geometryRoughness = max( max( dxy.x, dxy.y ), dxy.z );
material.roughness = max( roughnessFactor, 0.045 );
material.roughness += geometryRoughness;
material.roughness = min( material.roughness, 1.0 );
#ifdef USE_DIFFUSE_ROUGHNESS
	float diffuseRoughnessFactor = diffuseRoughness;
	#ifdef USE_DIFFUSE_ROUGHNESSMAP
		diffuseRoughnessFactor *= texture2D( diffuseRoughnessMap, vDiffuseRoughnessMapUv ).r;
	#endif
	material.diffuseRoughness = saturate( diffuseRoughnessFactor );
#endif
#ifdef IOR
	material.ior = ior;
	#ifdef USE_SPECULAR
		float specularIntensityFactor = specularIntensity;
		vec3 specularColorFactor = specularColor;
		#ifdef USE_SPECULAR_COLORMAP
			specularColorFactor *= texture2D( specularColorMap, vSpecularColorMapUv ).rgb;
		#endif
		#ifdef USE_SPECULAR_INTENSITYMAP
			specularIntensityFactor *= texture2D( specularIntensityMap, vSpecularIntensityMapUv ).a;
		#endif
		material.specularF90 = mix( specularIntensityFactor, 1.0, metalnessFactor );
	#else
		float specularIntensityFactor = 1.0;
		vec3 specularColorFactor = vec3( 1.0 );
		material.specularF90 = 1.0;
	#endif
	material.specularColor = min( pow2( ( material.ior - 1.0 ) / ( material.ior + 1.0 ) ) * specularColorFactor, vec3( 1.0 ) ) * specularIntensityFactor;
	material.specularColorBlended = mix( material.specularColor, diffuseColor.rgb, metalnessFactor );
#else
	material.specularColor = vec3( 0.04 );
	material.specularColorBlended = mix( material.specularColor, diffuseColor.rgb, metalnessFactor );
	material.specularF90 = 1.0;
#endif
#ifdef USE_CLEARCOAT
	material.clearcoat = clearcoat;
	material.clearcoatRoughness = clearcoatRoughness;
	material.clearcoatF0 = vec3( 0.04 );
	material.clearcoatF90 = 1.0;
	#ifdef USE_CLEARCOATMAP
		material.clearcoat *= texture2D( clearcoatMap, vClearcoatMapUv ).x;
	#endif
	#ifdef USE_CLEARCOAT_ROUGHNESSMAP
		material.clearcoatRoughness *= texture2D( clearcoatRoughnessMap, vClearcoatRoughnessMapUv ).y;
	#endif
	material.clearcoat = saturate( material.clearcoat );	material.clearcoatRoughness = max( material.clearcoatRoughness, 0.045 );
	material.clearcoatRoughness += geometryRoughness;
	material.clearcoatRoughness = min( material.clearcoatRoughness, 1.0 );
#endif
#ifdef USE_DISPERSION
	material.dispersion = dispersion;
#endif
#ifdef USE_RETROREFLECTION
	material.retroreflectivity = retroreflectivity;
#endif
#ifdef USE_IRIDESCENCE
	material.iridescence = iridescence;
	material.iridescenceIOR = iridescenceIOR;
	#ifdef USE_IRIDESCENCEMAP
		material.iridescence *= texture2D( iridescenceMap, vIridescenceMapUv ).r;
	#endif
	#ifdef USE_IRIDESCENCE_THICKNESSMAP
		material.iridescenceThickness = (iridescenceThicknessMaximum - iridescenceThicknessMinimum) * texture2D( iridescenceThicknessMap, vIridescenceThicknessMapUv ).g + iridescenceThicknessMinimum;
	#else
		material.iridescenceThickness = iridescenceThicknessMaximum;
	#endif
#endif
#ifdef USE_SHEEN
	material.sheenColor = sheenColor;
	#ifdef USE_SHEEN_COLORMAP
		material.sheenColor *= texture2D( sheenColorMap, vSheenColorMapUv ).rgb;
	#endif
	material.sheenRoughness = clamp( sheenRoughness, 0.0001, 1.0 );
	#ifdef USE_SHEEN_ROUGHNESSMAP
		material.sheenRoughness *= texture2D( sheenRoughnessMap, vSheenRoughnessMapUv ).a;
	#endif
#endif
#ifdef USE_ANISOTROPY
	#ifdef USE_ANISOTROPYMAP
		mat2 anisotropyMat = mat2( anisotropyVector.x, anisotropyVector.y, - anisotropyVector.y, anisotropyVector.x );
		vec3 anisotropyPolar = texture2D( anisotropyMap, vAnisotropyMapUv ).rgb;
		vec2 anisotropyV = anisotropyMat * normalize( 2.0 * anisotropyPolar.rg - vec2( 1.0 ) ) * anisotropyPolar.b;
	#else
		vec2 anisotropyV = anisotropyVector;
	#endif
	material.anisotropy = length( anisotropyV );
	if( material.anisotropy == 0.0 ) {
		anisotropyV = vec2( 1.0, 0.0 );
	} else {
		anisotropyV /= material.anisotropy;
		material.anisotropy = saturate( material.anisotropy );
	}
	material.alphaT = mix( pow2( material.roughness ), 1.0, pow2( material.anisotropy ) );
	material.anisotropyT = tbn[ 0 ] * anisotropyV.x + tbn[ 1 ] * anisotropyV.y;
	material.anisotropyB = tbn[ 1 ] * anisotropyV.x - tbn[ 0 ] * anisotropyV.y;
#endif`,KS=`uniform sampler2D dfgLUT;
struct PhysicalMaterial {
	vec3 diffuseColor;
	vec3 diffuseContribution;
	vec3 specularColor;
	vec3 specularColorBlended;
	float roughness;
	float metalness;
	float specularF90;
	float dispersion;
	vec2 dfg;
	vec3 multiScatteringCompensation;
	#ifdef USE_DIFFUSE_ROUGHNESS
		float diffuseRoughness;
	#endif
	#ifdef USE_RETROREFLECTION
		float retroreflectivity;
	#endif
	#ifdef USE_CLEARCOAT
		float clearcoat;
		float clearcoatRoughness;
		vec3 clearcoatF0;
		float clearcoatF90;
	#endif
	#ifdef USE_IRIDESCENCE
		float iridescence;
		float iridescenceIOR;
		float iridescenceThickness;
		vec3 iridescenceFresnel;
		vec3 iridescenceF0Dielectric;
		vec3 iridescenceF0Metallic;
	#endif
	#ifdef USE_SHEEN
		vec3 sheenColor;
		float sheenRoughness;
	#endif
	#ifdef IOR
		float ior;
	#endif
	#ifdef USE_TRANSMISSION
		float transmission;
		float transmissionAlpha;
		float thickness;
		float attenuationDistance;
		vec3 attenuationColor;
	#endif
	#ifdef USE_ANISOTROPY
		float anisotropy;
		float alphaT;
		vec3 anisotropyT;
		vec3 anisotropyB;
	#endif
};
vec3 clearcoatSpecularDirect = vec3( 0.0 );
vec3 clearcoatSpecularIndirect = vec3( 0.0 );
vec3 sheenSpecularDirect = vec3( 0.0 );
vec3 sheenSpecularIndirect = vec3(0.0 );
vec3 Schlick_to_F0( const in vec3 f, const in float f90, const in float dotVH ) {
    float x = clamp( 1.0 - dotVH, 0.0, 1.0 );
    float x2 = x * x;
    float x5 = clamp( x * x2 * x2, 0.0, 0.9999 );
    return ( f - vec3( f90 ) * x5 ) / ( 1.0 - x5 );
}
#ifdef USE_DIFFUSE_ROUGHNESS
	const float EON_EPSILON = 1e-7;
	float FON_DirectionalAlbedo( const in float mu, const in float roughness, const in float A ) {
		float muComp = 1.0 - mu;
		float gOverPi = muComp * ( 0.0571085289 + muComp * ( 0.491881867 + muComp * ( - 0.332181442 + muComp * 0.0714429953 ) ) );
		return A * ( 1.0 + roughness * gOverPi );
	}
	vec3 BRDF_EON( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in vec3 diffuseColor, const in float roughness ) {
		vec3 rho = saturate( diffuseColor );
		if ( roughness <= EON_EPSILON ) return BRDF_Lambert( rho );
		float dotNL = saturate( dot( normal, lightDir ) );
		float dotNV = saturate( dot( normal, viewDir ) );
		float s = dot( lightDir, viewDir ) - dotNL * dotNV;
		float sOverT = ( s > 0.0 ) ? s / max( max( dotNL, dotNV ), EON_EPSILON ) : s;
		float A = 1.0 / ( 1.0 + ( 0.5 - 2.0 / ( 3.0 * PI ) ) * roughness );
		vec3 singleScatter = rho * RECIPROCAL_PI * A * ( 1.0 + roughness * sOverT );
		float averageAlbedo = A * ( 1.0 + ( 2.0 / 3.0 - 28.0 / ( 15.0 * PI ) ) * roughness );
		float albedoV = FON_DirectionalAlbedo( dotNV, roughness, A );
		float albedoL = FON_DirectionalAlbedo( dotNL, roughness, A );
		vec3 rhoMultiScatter = rho * rho * averageAlbedo / max( vec3( EON_EPSILON ), vec3( 1.0 ) - rho * ( 1.0 - averageAlbedo ) );
		vec3 multiScatter = rhoMultiScatter * RECIPROCAL_PI
			* max( EON_EPSILON, 1.0 - albedoV )
			* max( EON_EPSILON, 1.0 - albedoL )
			/ max( EON_EPSILON, 1.0 - averageAlbedo );
		return singleScatter + multiScatter;
	}
	vec3 EON_DirectionalAlbedo( const in vec3 diffuseColor, const in float roughness, const in float dotNV ) {
		vec3 rho = saturate( diffuseColor );
		if ( roughness <= EON_EPSILON ) return rho;
		float A = 1.0 / ( 1.0 + ( 0.5 - 2.0 / ( 3.0 * PI ) ) * roughness );
		float directionalAlbedo = FON_DirectionalAlbedo( dotNV, roughness, A );
		float averageAlbedo = A * ( 1.0 + ( 2.0 / 3.0 - 28.0 / ( 15.0 * PI ) ) * roughness );
		vec3 rhoMultiScatter = rho * rho * averageAlbedo / max( vec3( EON_EPSILON ), vec3( 1.0 ) - rho * ( 1.0 - averageAlbedo ) );
		return rho * directionalAlbedo + rhoMultiScatter * ( 1.0 - directionalAlbedo );
	}
#endif
float V_GGX_SmithCorrelated( const in float alpha, const in float dotNL, const in float dotNV ) {
	float a2 = pow2( alpha );
	float gv = dotNL * sqrt( a2 + ( 1.0 - a2 ) * pow2( dotNV ) );
	float gl = dotNV * sqrt( a2 + ( 1.0 - a2 ) * pow2( dotNL ) );
	return 0.5 / max( gv + gl, EPSILON );
}
float D_GGX( const in float alpha, const in float dotNH ) {
	float a2 = pow2( alpha );
	float denom = pow2( dotNH ) * ( a2 - 1.0 ) + 1.0;
	return RECIPROCAL_PI * a2 / pow2( denom );
}
#ifdef USE_ANISOTROPY
	float V_GGX_SmithCorrelated_Anisotropic( const in float alphaT, const in float alphaB, const in float dotTV, const in float dotBV, const in float dotTL, const in float dotBL, const in float dotNV, const in float dotNL ) {
		float gv = dotNL * length( vec3( alphaT * dotTV, alphaB * dotBV, dotNV ) );
		float gl = dotNV * length( vec3( alphaT * dotTL, alphaB * dotBL, dotNL ) );
		return 0.5 / max( gv + gl, EPSILON );
	}
	float D_GGX_Anisotropic( const in float alphaT, const in float alphaB, const in float dotNH, const in float dotTH, const in float dotBH ) {
		float a2 = alphaT * alphaB;
		highp vec3 v = vec3( alphaB * dotTH, alphaT * dotBH, a2 * dotNH );
		highp float v2 = dot( v, v );
		float w2 = a2 / v2;
		return RECIPROCAL_PI * a2 * pow2 ( w2 );
	}
#endif
#ifdef USE_CLEARCOAT
	vec3 BRDF_GGX_Clearcoat( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in PhysicalMaterial material) {
		vec3 f0 = material.clearcoatF0;
		float f90 = material.clearcoatF90;
		float roughness = max( material.clearcoatRoughness, 0.045 );
		float alpha = pow2( roughness );
		vec3 halfDir = normalize( lightDir + viewDir );
		float dotNL = saturate( dot( normal, lightDir ) );
		float dotNV = saturate( dot( normal, viewDir ) );
		float dotNH = saturate( dot( normal, halfDir ) );
		float dotVH = saturate( dot( viewDir, halfDir ) );
		vec3 F = F_Schlick( f0, f90, dotVH );
		float V = V_GGX_SmithCorrelated( alpha, dotNL, dotNV );
		float D = D_GGX( alpha, dotNH );
		return F * ( V * D );
	}
#endif
vec3 BRDF_GGX( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in PhysicalMaterial material ) {
	vec3 f0 = material.specularColorBlended;
	float f90 = material.specularF90;
	float roughness = max( material.roughness, 0.045 );
	float alpha = pow2( roughness );
	vec3 halfDir = normalize( lightDir + viewDir );
	float dotNL = saturate( dot( normal, lightDir ) );
	float dotNV = saturate( dot( normal, viewDir ) );
	float dotNH = saturate( dot( normal, halfDir ) );
	float dotVH = saturate( dot( viewDir, halfDir ) );
	vec3 F = F_Schlick( f0, f90, dotVH );
	#ifdef USE_IRIDESCENCE
		F = mix( F, material.iridescenceFresnel, material.iridescence );
	#endif
	#ifdef USE_ANISOTROPY
		float dotTL = dot( material.anisotropyT, lightDir );
		float dotTV = dot( material.anisotropyT, viewDir );
		float dotTH = dot( material.anisotropyT, halfDir );
		float dotBL = dot( material.anisotropyB, lightDir );
		float dotBV = dot( material.anisotropyB, viewDir );
		float dotBH = dot( material.anisotropyB, halfDir );
		float alphaT = max( material.alphaT, alpha );
		float V = V_GGX_SmithCorrelated_Anisotropic( alphaT, alpha, dotTV, dotBV, dotTL, dotBL, dotNV, dotNL );
		float D = D_GGX_Anisotropic( alphaT, alpha, dotNH, dotTH, dotBH );
	#else
		float V = V_GGX_SmithCorrelated( alpha, dotNL, dotNV );
		float D = D_GGX( alpha, dotNH );
	#endif
	return F * ( V * D );
}
vec2 LTC_Uv( const in vec3 N, const in vec3 V, const in float roughness ) {
	const float LUT_SIZE = 64.0;
	const float LUT_SCALE = ( LUT_SIZE - 1.0 ) / LUT_SIZE;
	const float LUT_BIAS = 0.5 / LUT_SIZE;
	float dotNV = saturate( dot( N, V ) );
	vec2 uv = vec2( roughness, sqrt( 1.0 - dotNV ) );
	uv = uv * LUT_SCALE + LUT_BIAS;
	return uv;
}
float LTC_ClippedSphereFormFactor( const in vec3 f ) {
	float l = length( f );
	return max( ( l * l + f.z ) / ( l + 1.0 ), 0.0 );
}
vec3 LTC_EdgeVectorFormFactor( const in vec3 v1, const in vec3 v2 ) {
	float x = dot( v1, v2 );
	float y = abs( x );
	float a = 0.8543985 + ( 0.4965155 + 0.0145206 * y ) * y;
	float b = 3.4175940 + ( 4.1616724 + y ) * y;
	float v = a / b;
	float theta_sintheta = ( x > 0.0 ) ? v : 0.5 * inversesqrt( max( 1.0 - x * x, 1e-7 ) ) - v;
	return cross( v1, v2 ) * theta_sintheta;
}
vec3 LTC_Evaluate( const in vec3 N, const in vec3 V, const in vec3 P, const in mat3 mInv, const in vec3 rectCoords[ 4 ] ) {
	vec3 v1 = rectCoords[ 1 ] - rectCoords[ 0 ];
	vec3 v2 = rectCoords[ 3 ] - rectCoords[ 0 ];
	vec3 lightNormal = cross( v1, v2 );
	if( dot( lightNormal, P - rectCoords[ 0 ] ) < 0.0 ) return vec3( 0.0 );
	vec3 T1, T2;
	T1 = normalize( V - N * dot( V, N ) );
	T2 = - cross( N, T1 );
	mat3 mat = mInv * transpose( mat3( T1, T2, N ) );
	vec3 coords[ 4 ];
	coords[ 0 ] = mat * ( rectCoords[ 0 ] - P );
	coords[ 1 ] = mat * ( rectCoords[ 1 ] - P );
	coords[ 2 ] = mat * ( rectCoords[ 2 ] - P );
	coords[ 3 ] = mat * ( rectCoords[ 3 ] - P );
	coords[ 0 ] = normalize( coords[ 0 ] );
	coords[ 1 ] = normalize( coords[ 1 ] );
	coords[ 2 ] = normalize( coords[ 2 ] );
	coords[ 3 ] = normalize( coords[ 3 ] );
	vec3 vectorFormFactor = vec3( 0.0 );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 0 ], coords[ 1 ] );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 1 ], coords[ 2 ] );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 2 ], coords[ 3 ] );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 3 ], coords[ 0 ] );
	float result = LTC_ClippedSphereFormFactor( vectorFormFactor );
	return vec3( result );
}
#if defined( USE_SHEEN )
float D_Charlie( float roughness, float dotNH ) {
	float alpha = pow2( roughness );
	float invAlpha = 1.0 / alpha;
	float cos2h = dotNH * dotNH;
	float sin2h = max( 1.0 - cos2h, 0.0078125 );
	return ( 2.0 + invAlpha ) * pow( sin2h, invAlpha * 0.5 ) / ( 2.0 * PI );
}
float V_Neubelt( float dotNV, float dotNL ) {
	return saturate( 1.0 / ( 4.0 * ( dotNL + dotNV - dotNL * dotNV ) ) );
}
vec3 BRDF_Sheen( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, vec3 sheenColor, const in float sheenRoughness ) {
	vec3 halfDir = normalize( lightDir + viewDir );
	float dotNL = saturate( dot( normal, lightDir ) );
	float dotNV = saturate( dot( normal, viewDir ) );
	float dotNH = saturate( dot( normal, halfDir ) );
	float D = D_Charlie( sheenRoughness, dotNH );
	float V = V_Neubelt( dotNV, dotNL );
	return sheenColor * ( D * V );
}
#endif
float IBLSheenBRDF( const in vec3 normal, const in vec3 viewDir, const in float roughness ) {
	float dotNV = saturate( dot( normal, viewDir ) );
	float r2 = roughness * roughness;
	float rInv = 1.0 / ( roughness + 0.1 );
	float a = -1.9362 + 1.0678 * roughness + 0.4573 * r2 - 0.8469 * rInv;
	float b = -0.6014 + 0.5538 * roughness - 0.4670 * r2 - 0.1255 * rInv;
	float DG = exp( a * dotNV + b );
	return saturate( DG );
}
vec3 EnvironmentBRDF( const in vec3 normal, const in vec3 viewDir, const in vec3 specularColor, const in float specularF90, const in float roughness ) {
	float dotNV = saturate( dot( normal, viewDir ) );
	vec2 fab = texture2D( dfgLUT, vec2( roughness, dotNV ) ).rg;
	return specularColor * fab.x + specularF90 * fab.y;
}
#ifdef USE_IRIDESCENCE
void computeMultiscatteringIridescence( const in vec2 fab, const in vec3 specularColor, const in float specularF90, const in float iridescence, const in vec3 iridescenceF0, inout vec3 singleScatter, inout vec3 multiScatter ) {
#else
void computeMultiscattering( const in vec2 fab, const in vec3 specularColor, const in float specularF90, inout vec3 singleScatter, inout vec3 multiScatter ) {
#endif
	#ifdef USE_IRIDESCENCE
		vec3 Fr = mix( specularColor, iridescenceF0, iridescence );
	#else
		vec3 Fr = specularColor;
	#endif
	vec3 FssEss = Fr * fab.x + specularF90 * fab.y;
	float Ess = fab.x + fab.y;
	float Ems = 1.0 - Ess;
	vec3 Favg = Fr + ( 1.0 - Fr ) * 0.047619;	vec3 Fms = FssEss * Favg / ( 1.0 - Ems * Favg );
	singleScatter += FssEss;
	multiScatter += Fms * Ems;
}
#if NUM_RECT_AREA_LIGHTS > 0
	void RE_Direct_RectArea_Physical( const in RectAreaLight rectAreaLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight ) {
		vec3 normal = geometryNormal;
		vec3 viewDir = geometryViewDir;
		vec3 position = geometryPosition;
		vec3 lightPos = rectAreaLight.position;
		vec3 halfWidth = rectAreaLight.halfWidth;
		vec3 halfHeight = rectAreaLight.halfHeight;
		vec3 lightColor = rectAreaLight.color;
		float roughness = material.roughness;
		vec3 rectCoords[ 4 ];
		rectCoords[ 0 ] = lightPos + halfWidth - halfHeight;		rectCoords[ 1 ] = lightPos - halfWidth - halfHeight;
		rectCoords[ 2 ] = lightPos - halfWidth + halfHeight;
		rectCoords[ 3 ] = lightPos + halfWidth + halfHeight;
		vec2 uv = LTC_Uv( normal, viewDir, roughness );
		vec4 t1 = texture2D( ltc_1, uv );
		vec4 t2 = texture2D( ltc_2, uv );
		mat3 mInv = mat3(
			vec3( t1.x, 0, t1.y ),
			vec3(    0, 1,    0 ),
			vec3( t1.z, 0, t1.w )
		);
		vec3 fresnel = ( material.specularColorBlended * t2.x + ( material.specularF90 - material.specularColorBlended ) * t2.y );
		reflectedLight.directSpecular += lightColor * fresnel * LTC_Evaluate( normal, viewDir, position, mInv, rectCoords );
		reflectedLight.directDiffuse += lightColor * material.diffuseContribution * LTC_Evaluate( normal, viewDir, position, mat3( 1.0 ), rectCoords );
		#ifdef USE_CLEARCOAT
			vec3 Ncc = geometryClearcoatNormal;
			vec2 uvClearcoat = LTC_Uv( Ncc, viewDir, material.clearcoatRoughness );
			vec4 t1Clearcoat = texture2D( ltc_1, uvClearcoat );
			vec4 t2Clearcoat = texture2D( ltc_2, uvClearcoat );
			mat3 mInvClearcoat = mat3(
				vec3( t1Clearcoat.x, 0, t1Clearcoat.y ),
				vec3(             0, 1,             0 ),
				vec3( t1Clearcoat.z, 0, t1Clearcoat.w )
			);
			vec3 fresnelClearcoat = material.clearcoatF0 * t2Clearcoat.x + ( material.clearcoatF90 - material.clearcoatF0 ) * t2Clearcoat.y;
			clearcoatSpecularDirect += lightColor * fresnelClearcoat * LTC_Evaluate( Ncc, viewDir, position, mInvClearcoat, rectCoords );
		#endif
	}
#endif
void RE_Direct_Physical( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight ) {
	float dotNL = saturate( dot( geometryNormal, directLight.direction ) );
	vec3 irradiance = dotNL * directLight.color;
	#ifdef USE_CLEARCOAT
		float dotNLcc = saturate( dot( geometryClearcoatNormal, directLight.direction ) );
		vec3 ccIrradiance = dotNLcc * directLight.color;
		clearcoatSpecularDirect += ccIrradiance * BRDF_GGX_Clearcoat( directLight.direction, geometryViewDir, geometryClearcoatNormal, material );
	#endif
	#ifdef USE_SHEEN
 
 		sheenSpecularDirect += irradiance * BRDF_Sheen( directLight.direction, geometryViewDir, geometryNormal, material.sheenColor, material.sheenRoughness );
 
 		float sheenAlbedoV = IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness );
 		float sheenAlbedoL = IBLSheenBRDF( geometryNormal, directLight.direction, material.sheenRoughness );
 
 		float sheenEnergyComp = 1.0 - max3( material.sheenColor ) * max( sheenAlbedoV, sheenAlbedoL );
 
 		irradiance *= sheenEnergyComp;
 
 	#endif
	vec3 specularBRDF = BRDF_GGX( directLight.direction, geometryViewDir, geometryNormal, material );
	#ifdef USE_RETROREFLECTION
		vec3 retroViewDir = reflect( - geometryViewDir, geometryNormal );
		vec3 retroSpecularBRDF = BRDF_GGX( directLight.direction, retroViewDir, geometryNormal, material );
		specularBRDF = mix( specularBRDF, retroSpecularBRDF, saturate( material.retroreflectivity ) );
	#endif
	reflectedLight.directSpecular += irradiance * specularBRDF * material.multiScatteringCompensation;
	vec3 halfDir = normalize( directLight.direction + geometryViewDir );
	float dotVH = saturate( dot( geometryViewDir, halfDir ) );
	vec3 F = F_Schlick( material.specularColor, material.specularF90, dotVH );
	#ifdef USE_RETROREFLECTION
		vec3 retroHalfDir = normalize( directLight.direction + retroViewDir );
		float dotRetroVH = saturate( dot( retroViewDir, retroHalfDir ) );
		vec3 retroF = F_Schlick( material.specularColor, material.specularF90, dotRetroVH );
		F = mix( F, retroF, saturate( material.retroreflectivity ) );
	#endif
	#ifdef USE_DIFFUSE_ROUGHNESS
		vec3 diffuseBRDF = BRDF_EON( directLight.direction, geometryViewDir, geometryNormal, material.diffuseColor, material.diffuseRoughness ) * ( 1.0 - material.metalness );
	#else
		vec3 diffuseBRDF = BRDF_Lambert( material.diffuseContribution );
	#endif
	reflectedLight.directDiffuse += irradiance * diffuseBRDF * ( 1.0 - F );
}
void RE_IndirectDiffuse_Physical( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight ) {
	vec3 singleScattering = vec3( 0.0 );
	vec3 multiScattering = vec3( 0.0 );
	#ifdef USE_IRIDESCENCE
		computeMultiscatteringIridescence( material.dfg, material.specularColor, material.specularF90, material.iridescence, material.iridescenceF0Dielectric, singleScattering, multiScattering );
	#else
		computeMultiscattering( material.dfg, material.specularColor, material.specularF90, singleScattering, multiScattering );
	#endif
	#ifdef USE_DIFFUSE_ROUGHNESS
		float dotNV = saturate( dot( geometryNormal, geometryViewDir ) );
		vec3 diffuseAlbedo = EON_DirectionalAlbedo( material.diffuseColor, material.diffuseRoughness, dotNV ) * ( 1.0 - material.metalness );
		vec3 diffuse = irradiance * RECIPROCAL_PI * diffuseAlbedo * ( 1.0 - singleScattering - multiScattering );
	#else
		vec3 diffuse = irradiance * BRDF_Lambert( material.diffuseContribution ) * ( 1.0 - singleScattering - multiScattering );
	#endif
	#ifdef USE_SHEEN
		float sheenAlbedo = IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness );
		sheenSpecularIndirect += irradiance * material.sheenColor * sheenAlbedo * RECIPROCAL_PI;
		float sheenEnergyComp = 1.0 - max3( material.sheenColor ) * sheenAlbedo;
		diffuse *= sheenEnergyComp;
	#endif
	reflectedLight.indirectDiffuse += diffuse;
}
void RE_IndirectSpecular_Physical( const in vec3 radiance, const in vec3 irradiance, const in vec3 clearcoatRadiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight) {
	#ifdef USE_CLEARCOAT
		clearcoatSpecularIndirect += clearcoatRadiance * EnvironmentBRDF( geometryClearcoatNormal, geometryViewDir, material.clearcoatF0, material.clearcoatF90, material.clearcoatRoughness );
	#endif
	#ifdef USE_SHEEN
		sheenSpecularIndirect += irradiance * material.sheenColor * IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness ) * RECIPROCAL_PI;
 	#endif
	vec3 singleScatteringDielectric = vec3( 0.0 );
	vec3 multiScatteringDielectric = vec3( 0.0 );
	vec3 singleScatteringMetallic = vec3( 0.0 );
	vec3 multiScatteringMetallic = vec3( 0.0 );
	#ifdef USE_IRIDESCENCE
		computeMultiscatteringIridescence( material.dfg, material.specularColor, material.specularF90, material.iridescence, material.iridescenceF0Dielectric, singleScatteringDielectric, multiScatteringDielectric );
		computeMultiscatteringIridescence( material.dfg, material.diffuseColor, material.specularF90, material.iridescence, material.iridescenceF0Metallic, singleScatteringMetallic, multiScatteringMetallic );
	#else
		computeMultiscattering( material.dfg, material.specularColor, material.specularF90, singleScatteringDielectric, multiScatteringDielectric );
		computeMultiscattering( material.dfg, material.diffuseColor, material.specularF90, singleScatteringMetallic, multiScatteringMetallic );
	#endif
	vec3 singleScattering = mix( singleScatteringDielectric, singleScatteringMetallic, material.metalness );
	vec3 multiScattering = mix( multiScatteringDielectric, multiScatteringMetallic, material.metalness );
	vec3 totalScatteringDielectric = singleScatteringDielectric + multiScatteringDielectric;
	#ifdef USE_DIFFUSE_ROUGHNESS
		float dotNV = saturate( dot( geometryNormal, geometryViewDir ) );
		vec3 diffuse = EON_DirectionalAlbedo( material.diffuseColor, material.diffuseRoughness, dotNV ) * ( 1.0 - material.metalness ) * ( 1.0 - totalScatteringDielectric );
	#else
		vec3 diffuse = material.diffuseContribution * ( 1.0 - totalScatteringDielectric );
	#endif
	vec3 cosineWeightedIrradiance = irradiance * RECIPROCAL_PI;
	vec3 indirectSpecular = radiance * singleScattering;
	indirectSpecular += multiScattering * cosineWeightedIrradiance;
	vec3 indirectDiffuse = diffuse * cosineWeightedIrradiance;
	#ifdef USE_SHEEN
		float sheenAlbedo = IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness );
		float sheenEnergyComp = 1.0 - max3( material.sheenColor ) * sheenAlbedo;
		indirectSpecular *= sheenEnergyComp;
		indirectDiffuse *= sheenEnergyComp;
	#endif
	reflectedLight.indirectSpecular += indirectSpecular;
	reflectedLight.indirectDiffuse += indirectDiffuse;
}
#define RE_Direct				RE_Direct_Physical
#define RE_Direct_RectArea		RE_Direct_RectArea_Physical
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Physical
#define RE_IndirectSpecular		RE_IndirectSpecular_Physical
float computeSpecularOcclusion( const in float dotNV, const in float ambientOcclusion, const in float roughness ) {
	return saturate( pow( dotNV + ambientOcclusion, exp2( - 16.0 * roughness - 1.0 ) ) - 1.0 + ambientOcclusion );
}`,jS=`
vec3 geometryPosition = - vViewPosition;
vec3 geometryNormal = normal;
vec3 geometryViewDir = ( isOrthographic ) ? vec3( 0, 0, 1 ) : normalize( vViewPosition );
vec3 geometryClearcoatNormal = vec3( 0.0 );
#ifdef USE_CLEARCOAT
	geometryClearcoatNormal = clearcoatNormal;
#endif
#ifdef USE_IRIDESCENCE
	float dotNVi = saturate( dot( normal, geometryViewDir ) );
	if ( material.iridescenceThickness == 0.0 ) {
		material.iridescence = 0.0;
	} else {
		material.iridescence = saturate( material.iridescence );
	}
	if ( material.iridescence > 0.0 ) {
		vec3 iridescenceFresnelDielectric = evalIridescence( 1.0, material.iridescenceIOR, dotNVi, material.iridescenceThickness, material.specularColor );
		vec3 iridescenceFresnelMetallic = evalIridescence( 1.0, material.iridescenceIOR, dotNVi, material.iridescenceThickness, material.diffuseColor );
		material.iridescenceFresnel = mix( iridescenceFresnelDielectric, iridescenceFresnelMetallic, material.metalness );
		material.iridescenceF0Dielectric = Schlick_to_F0( iridescenceFresnelDielectric, 1.0, dotNVi );
		material.iridescenceF0Metallic = Schlick_to_F0( iridescenceFresnelMetallic, 1.0, dotNVi );
	}
#endif
#ifdef STANDARD
	float dotNVms = saturate( dot( geometryNormal, geometryViewDir ) );
	material.dfg = texture2D( dfgLUT, vec2( material.roughness, dotNVms ) ).rg;
	#if ( NUM_SUN_LIGHTS > 0 || NUM_DIR_LIGHTS > 0 || NUM_POINT_LIGHTS > 0 || NUM_SPOT_LIGHTS > 0 )
		float EssMs = material.dfg.x + material.dfg.y;
		material.multiScatteringCompensation = 1.0 + material.specularColorBlended * ( 1.0 / EssMs - 1.0 );
	#endif
#endif
IncidentLight directLight;
#if ( NUM_POINT_LIGHTS > 0 ) && defined( RE_Direct )
	PointLight pointLight;
	#if defined( USE_SHADOWMAP ) && NUM_POINT_LIGHT_SHADOWS > 0
	PointLightShadow pointLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_POINT_LIGHTS; i ++ ) {
		pointLight = pointLights[ i ];
		getPointLightInfo( pointLight, geometryPosition, directLight );
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_POINT_LIGHT_SHADOWS ) && ( defined( SHADOWMAP_TYPE_PCF ) || defined( SHADOWMAP_TYPE_BASIC ) )
		pointLightShadow = pointLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getPointShadow( pointShadowMap[ i ], pointLightShadow.shadowMapSize, pointLightShadow.shadowIntensity, pointLightShadow.shadowBias, pointLightShadow.shadowRadius, vPointShadowCoord[ i ], pointLightShadow.shadowCameraNear, pointLightShadow.shadowCameraFar ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_SPOT_LIGHTS > 0 ) && defined( RE_Direct )
	SpotLight spotLight;
	vec4 spotColor;
	vec3 spotLightCoord;
	bool inSpotLightMap;
	#if defined( USE_SHADOWMAP ) && NUM_SPOT_LIGHT_SHADOWS > 0
	SpotLightShadow spotLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SPOT_LIGHTS; i ++ ) {
		spotLight = spotLights[ i ];
		getSpotLightInfo( spotLight, geometryPosition, directLight );
		#if ( UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS )
		#define SPOT_LIGHT_MAP_INDEX UNROLLED_LOOP_INDEX
		#elif ( UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS )
		#define SPOT_LIGHT_MAP_INDEX NUM_SPOT_LIGHT_MAPS
		#else
		#define SPOT_LIGHT_MAP_INDEX ( UNROLLED_LOOP_INDEX - NUM_SPOT_LIGHT_SHADOWS + NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS )
		#endif
		#if ( SPOT_LIGHT_MAP_INDEX < NUM_SPOT_LIGHT_MAPS )
			spotLightCoord = vSpotLightCoord[ i ].xyz / vSpotLightCoord[ i ].w;
			inSpotLightMap = all( lessThan( abs( spotLightCoord * 2. - 1. ), vec3( 1.0 ) ) );
			spotColor = texture2D( spotLightMap[ SPOT_LIGHT_MAP_INDEX ], spotLightCoord.xy );
			directLight.color = inSpotLightMap ? directLight.color * spotColor.rgb : directLight.color;
		#endif
		#undef SPOT_LIGHT_MAP_INDEX
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS )
		spotLightShadow = spotLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getShadow( spotShadowMap[ i ], spotLightShadow.shadowMapSize, spotLightShadow.shadowIntensity, spotLightShadow.shadowBias, spotLightShadow.shadowRadius, vSpotLightCoord[ i ] ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_SUN_LIGHTS > 0 ) && defined( RE_Direct )
	SunLight sunLight;
	#if defined( USE_SHADOWMAP ) && NUM_SUN_LIGHT_SHADOWS > 0
	SunLightShadow sunLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SUN_LIGHTS; i ++ ) {
		sunLight = sunLights[ i ];
		getSunLightInfo( sunLight, directLight );
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_SUN_LIGHT_SHADOWS )
		sunLightShadow = sunLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getSunShadow( sunShadowMap[ i ], sunLightShadow, UNROLLED_LOOP_INDEX ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_DIR_LIGHTS > 0 ) && defined( RE_Direct )
	DirectionalLight directionalLight;
	#if defined( USE_SHADOWMAP ) && NUM_DIR_LIGHT_SHADOWS > 0
	DirectionalLightShadow directionalLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_DIR_LIGHTS; i ++ ) {
		directionalLight = directionalLights[ i ];
		getDirectionalLightInfo( directionalLight, directLight );
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_DIR_LIGHT_SHADOWS )
		directionalLightShadow = directionalLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getShadow( directionalShadowMap[ i ], directionalLightShadow.shadowMapSize, directionalLightShadow.shadowIntensity, directionalLightShadow.shadowBias, directionalLightShadow.shadowRadius, vDirectionalShadowCoord[ i ] ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_RECT_AREA_LIGHTS > 0 ) && defined( RE_Direct_RectArea )
	RectAreaLight rectAreaLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_RECT_AREA_LIGHTS; i ++ ) {
		rectAreaLight = rectAreaLights[ i ];
		RE_Direct_RectArea( rectAreaLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if defined( RE_IndirectDiffuse )
	vec3 iblIrradiance = vec3( 0.0 );
	vec3 irradiance = getAmbientLightIrradiance( ambientLightColor );
	#if defined( USE_LIGHT_PROBES )
		irradiance += getLightProbeIrradiance( lightProbe, geometryNormal );
	#endif
	#if ( NUM_HEMI_LIGHTS > 0 )
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_HEMI_LIGHTS; i ++ ) {
			irradiance += getHemisphereLightIrradiance( hemisphereLights[ i ], geometryNormal );
		}
		#pragma unroll_loop_end
	#endif
	#if NUM_LIGHT_PROBE_GRIDS > 0
		vec3 probeWorldPos = ( ( vec4( geometryPosition, 1.0 ) - viewMatrix[ 3 ] ) * viewMatrix ).xyz;
		vec3 probeWorldNormal = transformNormalByInverseViewMatrix( geometryNormal, viewMatrix );
		int probeGrid = - 1;
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_LIGHT_PROBE_GRIDS; i ++ ) {
			if ( isInsideLightProbeGrid( probeWorldPos, probeWorldNormal, probesMin[ i ], probesMax[ i ], probesResolution[ i ] ) ) probeGrid = UNROLLED_LOOP_INDEX;
		}
		#pragma unroll_loop_end
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_LIGHT_PROBE_GRIDS; i ++ ) {
			if ( probeGrid == UNROLLED_LOOP_INDEX ) irradiance += getLightProbeGridIrradiance( probesSH[ i ], probesMin[ i ], probesMax[ i ], probesResolution[ i ], probeWorldPos, probeWorldNormal );
		}
		#pragma unroll_loop_end
	#endif
#endif
#if defined( RE_IndirectSpecular )
	vec3 radiance = vec3( 0.0 );
	vec3 clearcoatRadiance = vec3( 0.0 );
#endif`,QS=`#if defined( RE_IndirectDiffuse )
	#ifdef USE_LIGHTMAP
		vec4 lightMapTexel = texture2D( lightMap, vLightMapUv );
		vec3 lightMapIrradiance = lightMapTexel.rgb * lightMapIntensity;
		irradiance += lightMapIrradiance;
	#endif
	#if defined( USE_ENVMAP ) && defined( ENVMAP_TYPE_PMREM )
		#if defined( STANDARD ) || defined( LAMBERT ) || defined( PHONG )
			iblIrradiance += getIBLIrradiance( geometryNormal );
		#endif
	#endif
#endif
#if defined( USE_ENVMAP ) && defined( RE_IndirectSpecular )
	#ifdef USE_ANISOTROPY
		vec3 iblRadiance = getIBLAnisotropyRadiance( geometryViewDir, geometryNormal, material.roughness, material.anisotropyB, material.anisotropy );
	#else
		vec3 iblRadiance = getIBLRadiance( geometryViewDir, geometryNormal, material.roughness );
	#endif
	#ifdef USE_RETROREFLECTION
		#ifdef USE_ANISOTROPY
			vec3 retroIBLRadiance = getIBLAnisotropyRetroRadiance( geometryViewDir, geometryNormal, material.roughness, material.anisotropyB, material.anisotropy );
		#else
			vec3 retroIBLRadiance = getIBLRetroRadiance( geometryViewDir, geometryNormal, material.roughness );
		#endif
		iblRadiance = mix( iblRadiance, retroIBLRadiance, saturate( material.retroreflectivity ) );
	#endif
	radiance += iblRadiance;
	#ifdef USE_CLEARCOAT
		clearcoatRadiance += getIBLRadiance( geometryViewDir, geometryClearcoatNormal, material.clearcoatRoughness );
	#endif
#endif`,tM=`#if defined( RE_IndirectDiffuse )
	#if defined( LAMBERT ) || defined( PHONG )
		irradiance += iblIrradiance;
	#endif
	RE_IndirectDiffuse( irradiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif
#if defined( RE_IndirectSpecular )
	RE_IndirectSpecular( radiance, iblIrradiance, clearcoatRadiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif`,eM=`#if NUM_LIGHT_PROBE_GRIDS > 0
uniform highp sampler3D probesSH[ NUM_LIGHT_PROBE_GRIDS ];
uniform vec3 probesMin[ NUM_LIGHT_PROBE_GRIDS ];
uniform vec3 probesMax[ NUM_LIGHT_PROBE_GRIDS ];
uniform vec3 probesResolution[ NUM_LIGHT_PROBE_GRIDS ];
bool isInsideLightProbeGrid( vec3 worldPos, vec3 worldNormal, vec3 probesMin, vec3 probesMax, vec3 probesResolution ) {
	vec3 spacing = ( probesMax - probesMin ) / probesResolution;
	vec3 samplePos = worldPos + worldNormal * spacing * 0.5;
	vec3 margin = spacing * 0.01;
	return all( greaterThanEqual( samplePos, probesMin - margin ) ) && all( lessThanEqual( samplePos, probesMax + margin ) );
}
vec3 getLightProbeGridIrradiance( highp sampler3D probesSH, vec3 probesMin, vec3 probesMax, vec3 probesResolution, vec3 worldPos, vec3 worldNormal ) {
	vec3 res = probesResolution;
	vec3 gridRange = probesMax - probesMin;
	vec3 probeSpacing = gridRange / res;
	vec3 samplePos = worldPos + worldNormal * probeSpacing * 0.5;
	vec3 uvw = clamp( ( samplePos - probesMin ) / gridRange, 0.5 / res, 1.0 - 0.5 / res );
	float nz          = res.z;
	float paddedSlices = nz + 2.0;
	float atlasDepth  = 7.0 * paddedSlices;
	float uvZBase     = uvw.z * nz + 1.0;
	vec4 s0 = texture( probesSH, vec3( uvw.xy, ( uvZBase                       ) / atlasDepth ) );
	vec4 s1 = texture( probesSH, vec3( uvw.xy, ( uvZBase +       paddedSlices   ) / atlasDepth ) );
	vec4 s2 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 2.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s3 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 3.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s4 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 4.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s5 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 5.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s6 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 6.0 * paddedSlices   ) / atlasDepth ) );
	vec3 c0 = s0.xyz;
	vec3 c1 = vec3( s0.w, s1.xy );
	vec3 c2 = vec3( s1.zw, s2.x );
	vec3 c3 = s2.yzw;
	vec3 c4 = s3.xyz;
	vec3 c5 = vec3( s3.w, s4.xy );
	vec3 c6 = vec3( s4.zw, s5.x );
	vec3 c7 = s5.yzw;
	vec3 c8 = s6.xyz;
	float x = worldNormal.x, y = worldNormal.y, z = worldNormal.z;
	vec3 result = c0 * 0.886227;
	result += c1 * 2.0 * 0.511664 * y;
	result += c2 * 2.0 * 0.511664 * z;
	result += c3 * 2.0 * 0.511664 * x;
	result += c4 * 2.0 * 0.429043 * x * y;
	result += c5 * 2.0 * 0.429043 * y * z;
	result += c6 * ( 0.743125 * z * z - 0.247708 );
	result += c7 * 2.0 * 0.429043 * x * z;
	result += c8 * 0.429043 * ( x * x - y * y );
	return max( result, vec3( 0.0 ) );
}
#endif`,nM=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	gl_FragDepth = vIsPerspective == 0.0 ? gl_FragCoord.z : log2( vFragDepth ) * logDepthBufFC * 0.5;
#endif`,iM=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	uniform float logDepthBufFC;
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,sM=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,rM=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	vFragDepth = 1.0 + gl_Position.w;
	vIsPerspective = float( isPerspectiveMatrix( projectionMatrix ) );
#endif`,oM=`#ifdef USE_MAP
	vec4 sampledDiffuseColor = texture2D( map, vMapUv );
	#ifdef DECODE_VIDEO_TEXTURE
		sampledDiffuseColor = sRGBTransferEOTF( sampledDiffuseColor );
	#endif
	diffuseColor *= sampledDiffuseColor;
#endif`,aM=`#ifdef USE_MAP
	uniform sampler2D map;
#endif`,lM=`#if defined( USE_MAP ) || defined( USE_ALPHAMAP )
	#if defined( USE_POINTS_UV )
		vec2 uv = vUv;
	#else
		vec2 uv = ( uvTransform * vec3( gl_PointCoord.x, 1.0 - gl_PointCoord.y, 1 ) ).xy;
	#endif
#endif
#ifdef USE_MAP
	diffuseColor *= texture2D( map, uv );
#endif
#ifdef USE_ALPHAMAP
	diffuseColor.a *= texture2D( alphaMap, uv ).g;
#endif`,cM=`#if defined( USE_POINTS_UV )
	varying vec2 vUv;
#else
	#if defined( USE_MAP ) || defined( USE_ALPHAMAP )
		uniform mat3 uvTransform;
	#endif
#endif
#ifdef USE_MAP
	uniform sampler2D map;
#endif
#ifdef USE_ALPHAMAP
	uniform sampler2D alphaMap;
#endif`,hM=`float metalnessFactor = metalness;
#ifdef USE_METALNESSMAP
	vec4 texelMetalness = texture2D( metalnessMap, vMetalnessMapUv );
	metalnessFactor *= texelMetalness.b;
#endif`,uM=`#ifdef USE_METALNESSMAP
	uniform sampler2D metalnessMap;
#endif`,fM=`#ifdef USE_INSTANCING_MORPH
	float morphTargetInfluences[ MORPHTARGETS_COUNT ];
	float morphTargetBaseInfluence = texelFetch( morphTexture, ivec2( 0, gl_InstanceID ), 0 ).r;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		morphTargetInfluences[i] =  texelFetch( morphTexture, ivec2( i + 1, gl_InstanceID ), 0 ).r;
	}
#endif`,dM=`#if defined( USE_MORPHCOLORS )
	#if defined( USE_COLOR_ALPHA )
		vColor *= morphTargetBaseInfluence;
	#elif defined( USE_COLOR )
		vColor.rgb *= morphTargetBaseInfluence;
	#endif
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		#if defined( USE_COLOR_ALPHA )
			if ( morphTargetInfluences[ i ] != 0.0 ) vColor += getMorph( gl_VertexID, i, 2 ) * morphTargetInfluences[ i ];
		#elif defined( USE_COLOR )
			if ( morphTargetInfluences[ i ] != 0.0 ) vColor.rgb += getMorph( gl_VertexID, i, 2 ).rgb * morphTargetInfluences[ i ];
		#endif
	}
#endif`,pM=`#ifdef USE_MORPHNORMALS
	objectNormal *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) objectNormal += getMorph( gl_VertexID, i, 1 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,mM=`#ifdef USE_MORPHTARGETS
	#ifndef USE_INSTANCING_MORPH
		uniform float morphTargetBaseInfluence;
		uniform float morphTargetInfluences[ MORPHTARGETS_COUNT ];
	#endif
	uniform sampler2DArray morphTargetsTexture;
	uniform ivec2 morphTargetsTextureSize;
	vec4 getMorph( const in int vertexIndex, const in int morphTargetIndex, const in int offset ) {
		int texelIndex = vertexIndex * MORPHTARGETS_TEXTURE_STRIDE + offset;
		int y = texelIndex / morphTargetsTextureSize.x;
		int x = texelIndex - y * morphTargetsTextureSize.x;
		ivec3 morphUV = ivec3( x, y, morphTargetIndex );
		return texelFetch( morphTargetsTexture, morphUV, 0 );
	}
#endif`,gM=`#ifdef USE_MORPHTARGETS
	transformed *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) transformed += getMorph( gl_VertexID, i, 0 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,_M=`float faceDirection = gl_FrontFacing ? 1.0 : - 1.0;
#ifdef FLAT_SHADED
	vec3 fdx = dFdx( vViewPosition );
	vec3 fdy = dFdy( vViewPosition );
	vec3 normal = normalize( cross( fdx, fdy ) );
#else
	vec3 normal = normalize( vNormal );
	#ifdef DOUBLE_SIDED
		normal *= faceDirection;
	#endif
#endif
#if defined( USE_NORMALMAP_TANGENTSPACE ) || defined( USE_CLEARCOAT_NORMALMAP ) || defined( USE_ANISOTROPY )
	#ifdef USE_TANGENT
		mat3 tbn = mat3( normalize( vTangent ), normalize( vBitangent ), normal );
	#else
		mat3 tbn = getTangentFrame( - vViewPosition, normal,
		#if defined( USE_NORMALMAP )
			vNormalMapUv
		#elif defined( USE_CLEARCOAT_NORMALMAP )
			vClearcoatNormalMapUv
		#else
			vUv
		#endif
		);
	#endif
	#ifdef DOUBLE_SIDED
		tbn[0] *= faceDirection;
		tbn[1] *= faceDirection;
	#endif
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	#ifdef USE_TANGENT
		mat3 tbn2 = mat3( normalize( vTangent ), normalize( vBitangent ), normal );
	#else
		mat3 tbn2 = getTangentFrame( - vViewPosition, normal, vClearcoatNormalMapUv );
	#endif
	#ifdef DOUBLE_SIDED
		tbn2[0] *= faceDirection;
		tbn2[1] *= faceDirection;
	#endif
#endif
vec3 nonPerturbedNormal = normal;`,xM=`#ifdef USE_NORMALMAP_OBJECTSPACE
	normal = texture2D( normalMap, vNormalMapUv ).xyz * 2.0 - 1.0;
	#ifdef FLIP_SIDED
		normal = - normal;
	#endif
	#ifdef DOUBLE_SIDED
		normal = normal * faceDirection;
	#endif
	normal = normalize( normalMatrix * normal );
#elif defined( USE_NORMALMAP_TANGENTSPACE )
	vec3 mapN = texture2D( normalMap, vNormalMapUv ).xyz * 2.0 - 1.0;
	#if defined( USE_PACKED_NORMALMAP )
		mapN = vec3( mapN.xy, sqrt( saturate( 1.0 - dot( mapN.xy, mapN.xy ) ) ) );
	#endif
	mapN.xy *= normalScale;
	normal = normalize( tbn * mapN );
#elif defined( USE_BUMPMAP )
	normal = perturbNormalArb( - vViewPosition, normal, dHdxy_fwd(), faceDirection );
#endif`,yM=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,vM=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,SM=`#ifndef FLAT_SHADED
	vNormal = normalize( transformedNormal );
	#ifdef USE_TANGENT
		vTangent = normalize( transformedTangent );
		vBitangent = normalize( cross( vNormal, vTangent ) * tangent.w );
		#ifdef FLIP_SIDED
			vBitangent = - vBitangent;
		#endif
	#endif
#endif`,MM=`#ifdef USE_NORMALMAP
	uniform sampler2D normalMap;
	uniform vec2 normalScale;
#endif
#ifdef USE_NORMALMAP_OBJECTSPACE
	uniform mat3 normalMatrix;
#endif
#if ! defined ( USE_TANGENT ) && ( defined ( USE_NORMALMAP_TANGENTSPACE ) || defined ( USE_CLEARCOAT_NORMALMAP ) || defined( USE_ANISOTROPY ) )
	mat3 getTangentFrame( vec3 eye_pos, vec3 surf_norm, vec2 uv ) {
		vec3 q0 = dFdx( eye_pos.xyz );
		vec3 q1 = dFdy( eye_pos.xyz );
		vec2 st0 = dFdx( uv.st );
		vec2 st1 = dFdy( uv.st );
		vec3 N = surf_norm;
		vec3 q1perp = cross( q1, N );
		vec3 q0perp = cross( N, q0 );
		vec3 T = q1perp * st0.x + q0perp * st1.x;
		vec3 B = q1perp * st0.y + q0perp * st1.y;
		float det = max( dot( T, T ), dot( B, B ) );
		float scale = ( det == 0.0 ) ? 0.0 : inversesqrt( det );
		return mat3( T * scale, B * scale, N );
	}
#endif`,bM=`#ifdef USE_CLEARCOAT
	vec3 clearcoatNormal = nonPerturbedNormal;
#endif`,wM=`#ifdef USE_CLEARCOAT_NORMALMAP
	vec3 clearcoatMapN = texture2D( clearcoatNormalMap, vClearcoatNormalMapUv ).xyz * 2.0 - 1.0;
	clearcoatMapN.xy *= clearcoatNormalScale;
	clearcoatNormal = normalize( tbn2 * clearcoatMapN );
#endif`,TM=`#ifdef USE_CLEARCOATMAP
	uniform sampler2D clearcoatMap;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	uniform sampler2D clearcoatNormalMap;
	uniform vec2 clearcoatNormalScale;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	uniform sampler2D clearcoatRoughnessMap;
#endif`,EM=`#ifdef USE_IRIDESCENCEMAP
	uniform sampler2D iridescenceMap;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	uniform sampler2D iridescenceThicknessMap;
#endif`,AM=`#ifdef OPAQUE
diffuseColor.a = 1.0;
#endif
#ifdef USE_TRANSMISSION
diffuseColor.a *= material.transmissionAlpha;
#endif
gl_FragColor = vec4( outgoingLight, diffuseColor.a );`,CM=`vec3 packNormalToRGB( const in vec3 normal ) {
	return normalize( normal ) * 0.5 + 0.5;
}
vec3 unpackRGBToNormal( const in vec3 rgb ) {
	return 2.0 * rgb.xyz - 1.0;
}
const float PackUpscale = 256. / 255.;const float UnpackDownscale = 255. / 256.;const float ShiftRight8 = 1. / 256.;
const float Inv255 = 1. / 255.;
const vec4 PackFactors = vec4( 1.0, 256.0, 256.0 * 256.0, 256.0 * 256.0 * 256.0 );
const vec2 UnpackFactors2 = vec2( UnpackDownscale, 1.0 / PackFactors.g );
const vec3 UnpackFactors3 = vec3( UnpackDownscale / PackFactors.rg, 1.0 / PackFactors.b );
const vec4 UnpackFactors4 = vec4( UnpackDownscale / PackFactors.rgb, 1.0 / PackFactors.a );
vec4 packDepthToRGBA( const in float v ) {
	if( v <= 0.0 )
		return vec4( 0., 0., 0., 0. );
	if( v >= 1.0 )
		return vec4( 1., 1., 1., 1. );
	float vuf;
	float af = modf( v * PackFactors.a, vuf );
	float bf = modf( vuf * ShiftRight8, vuf );
	float gf = modf( vuf * ShiftRight8, vuf );
	return vec4( vuf * Inv255, gf * PackUpscale, bf * PackUpscale, af );
}
vec3 packDepthToRGB( const in float v ) {
	if( v <= 0.0 )
		return vec3( 0., 0., 0. );
	if( v >= 1.0 )
		return vec3( 1., 1., 1. );
	float vuf;
	float bf = modf( v * PackFactors.b, vuf );
	float gf = modf( vuf * ShiftRight8, vuf );
	return vec3( vuf * Inv255, gf * PackUpscale, bf );
}
vec2 packDepthToRG( const in float v ) {
	if( v <= 0.0 )
		return vec2( 0., 0. );
	if( v >= 1.0 )
		return vec2( 1., 1. );
	float vuf;
	float gf = modf( v * 256., vuf );
	return vec2( vuf * Inv255, gf );
}
float unpackRGBAToDepth( const in vec4 v ) {
	return dot( v, UnpackFactors4 );
}
float unpackRGBToDepth( const in vec3 v ) {
	return dot( v, UnpackFactors3 );
}
float unpackRGToDepth( const in vec2 v ) {
	return v.r * UnpackFactors2.r + v.g * UnpackFactors2.g;
}
vec4 pack2HalfToRGBA( const in vec2 v ) {
	vec4 r = vec4( v.x, fract( v.x * 255.0 ), v.y, fract( v.y * 255.0 ) );
	return vec4( r.x - r.y / 255.0, r.y, r.z - r.w / 255.0, r.w );
}
vec2 unpackRGBATo2Half( const in vec4 v ) {
	return vec2( v.x + ( v.y / 255.0 ), v.z + ( v.w / 255.0 ) );
}
float viewZToOrthographicDepth( const in float viewZ, const in float near, const in float far ) {
	return ( viewZ + near ) / ( near - far );
}
float orthographicDepthToViewZ( const in float depth, const in float near, const in float far ) {
	#ifdef USE_REVERSED_DEPTH_BUFFER
	
		return depth * ( far - near ) - far;
	#else
		return depth * ( near - far ) - near;
	#endif
}
float viewZToPerspectiveDepth( const in float viewZ, const in float near, const in float far ) {
	return ( ( near + viewZ ) * far ) / ( ( far - near ) * viewZ );
}
float perspectiveDepthToViewZ( const in float depth, const in float near, const in float far ) {
	
	#ifdef USE_REVERSED_DEPTH_BUFFER
		return ( near * far ) / ( ( near - far ) * depth - near );
	#else
		return ( near * far ) / ( ( far - near ) * depth - far );
	#endif
}`,RM=`#ifdef PREMULTIPLIED_ALPHA
	gl_FragColor.rgb *= gl_FragColor.a;
#endif`,PM=`vec4 mvPosition = vec4( transformed, 1.0 );
#ifdef USE_BATCHING
	mvPosition = batchingMatrix * mvPosition;
#endif
#ifdef USE_INSTANCING
	mvPosition = instanceMatrix * mvPosition;
#endif
mvPosition = modelViewMatrix * mvPosition;
gl_Position = projectionMatrix * mvPosition;`,IM=`#ifdef DITHERING
	gl_FragColor.rgb = dithering( gl_FragColor.rgb );
#endif`,LM=`#ifdef DITHERING
	vec3 dithering( vec3 color ) {
		float grid_position = rand( gl_FragCoord.xy );
		vec3 dither_shift_RGB = vec3( 0.25 / 255.0, -0.25 / 255.0, 0.25 / 255.0 );
		dither_shift_RGB = mix( 2.0 * dither_shift_RGB, -2.0 * dither_shift_RGB, grid_position );
		return color + dither_shift_RGB;
	}
#endif`,DM=`float roughnessFactor = roughness;
#ifdef USE_ROUGHNESSMAP
	vec4 texelRoughness = texture2D( roughnessMap, vRoughnessMapUv );
	roughnessFactor *= texelRoughness.g;
#endif`,NM=`#ifdef USE_ROUGHNESSMAP
	uniform sampler2D roughnessMap;
#endif`,UM=`#if NUM_SPOT_LIGHT_COORDS > 0
	varying vec4 vSpotLightCoord[ NUM_SPOT_LIGHT_COORDS ];
#endif
#if NUM_SPOT_LIGHT_MAPS > 0
	uniform sampler2D spotLightMap[ NUM_SPOT_LIGHT_MAPS ];
#endif
#ifdef USE_SHADOWMAP
	#if NUM_SUN_LIGHT_SHADOWS > 0
		#define SUN_LIGHT_CASCADES 2
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform sampler2DShadow sunShadowMap[ NUM_SUN_LIGHT_SHADOWS ];
		#else
			uniform sampler2D sunShadowMap[ NUM_SUN_LIGHT_SHADOWS ];
		#endif
		uniform mat4 sunShadowMatrix[ NUM_SUN_LIGHT_SHADOWS * SUN_LIGHT_CASCADES ];
		uniform vec4 sunShadowCascade[ NUM_SUN_LIGHT_SHADOWS * SUN_LIGHT_CASCADES ];
		varying vec4 vSunShadowWorldPosition;
		varying vec3 vSunShadowWorldNormal;
		struct SunLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform SunLightShadow sunLightShadows[ NUM_SUN_LIGHT_SHADOWS ];
	#endif
	#if NUM_DIR_LIGHT_SHADOWS > 0
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform sampler2DShadow directionalShadowMap[ NUM_DIR_LIGHT_SHADOWS ];
		#else
			uniform sampler2D directionalShadowMap[ NUM_DIR_LIGHT_SHADOWS ];
		#endif
		varying vec4 vDirectionalShadowCoord[ NUM_DIR_LIGHT_SHADOWS ];
		struct DirectionalLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform DirectionalLightShadow directionalLightShadows[ NUM_DIR_LIGHT_SHADOWS ];
	#endif
	#if NUM_SPOT_LIGHT_SHADOWS > 0
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform sampler2DShadow spotShadowMap[ NUM_SPOT_LIGHT_SHADOWS ];
		#else
			uniform sampler2D spotShadowMap[ NUM_SPOT_LIGHT_SHADOWS ];
		#endif
		struct SpotLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform SpotLightShadow spotLightShadows[ NUM_SPOT_LIGHT_SHADOWS ];
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform samplerCubeShadow pointShadowMap[ NUM_POINT_LIGHT_SHADOWS ];
		#elif defined( SHADOWMAP_TYPE_BASIC )
			uniform samplerCube pointShadowMap[ NUM_POINT_LIGHT_SHADOWS ];
		#endif
		varying vec4 vPointShadowCoord[ NUM_POINT_LIGHT_SHADOWS ];
		struct PointLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
			float shadowCameraNear;
			float shadowCameraFar;
		};
		uniform PointLightShadow pointLightShadows[ NUM_POINT_LIGHT_SHADOWS ];
	#endif
	#if defined( SHADOWMAP_TYPE_PCF )
		float interleavedGradientNoise( vec2 position ) {
			return fract( 52.9829189 * fract( dot( position, vec2( 0.06711056, 0.00583715 ) ) ) );
		}
		vec2 vogelDiskSample( int sampleIndex, int samplesCount, float phi ) {
			const float goldenAngle = 2.399963229728653;
			float r = sqrt( ( float( sampleIndex ) + 0.5 ) / float( samplesCount ) );
			float theta = float( sampleIndex ) * goldenAngle + phi;
			return vec2( cos( theta ), sin( theta ) ) * r;
		}
	#endif
	#if defined( SHADOWMAP_TYPE_PCF )
		float getShadow( sampler2DShadow shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord ) {
			float shadow = 1.0;
			shadowCoord.xyz /= shadowCoord.w;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				shadowCoord.z -= shadowBias;
			#else
				shadowCoord.z += shadowBias;
			#endif
			bool inFrustum = shadowCoord.x >= 0.0 && shadowCoord.x <= 1.0 && shadowCoord.y >= 0.0 && shadowCoord.y <= 1.0;
			bool frustumTest = inFrustum && shadowCoord.z <= 1.0;
			if ( frustumTest ) {
				vec2 texelSize = vec2( 1.0 ) / shadowMapSize;
				vec2 radius = shadowRadius * texelSize;
				float phi = interleavedGradientNoise( gl_FragCoord.xy ) * PI2;
				shadow = (
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 0, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 1, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 2, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 3, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 4, 5, phi ) * radius, shadowCoord.z ) )
				) * 0.2;
			}
			return mix( 1.0, shadow, shadowIntensity );
		}
	#elif defined( SHADOWMAP_TYPE_VSM )
		float getShadow( sampler2D shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord ) {
			float shadow = 1.0;
			shadowCoord.xyz /= shadowCoord.w;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				shadowCoord.z -= shadowBias;
			#else
				shadowCoord.z += shadowBias;
			#endif
			bool inFrustum = shadowCoord.x >= 0.0 && shadowCoord.x <= 1.0 && shadowCoord.y >= 0.0 && shadowCoord.y <= 1.0;
			bool frustumTest = inFrustum && shadowCoord.z <= 1.0;
			if ( frustumTest ) {
				vec2 distribution = texture2D( shadowMap, shadowCoord.xy ).rg;
				float mean = distribution.x;
				float variance = distribution.y * distribution.y;
				#ifdef USE_REVERSED_DEPTH_BUFFER
					float hard_shadow = step( mean, shadowCoord.z );
				#else
					float hard_shadow = step( shadowCoord.z, mean );
				#endif
				
				if ( hard_shadow == 1.0 ) {
					shadow = 1.0;
				} else {
					variance = max( variance, 0.0000001 );
					float d = shadowCoord.z - mean;
					float p_max = variance / ( variance + d * d );
					p_max = clamp( ( p_max - 0.3 ) / 0.65, 0.0, 1.0 );
					shadow = max( hard_shadow, p_max );
				}
			}
			return mix( 1.0, shadow, shadowIntensity );
		}
	#else
		float getShadow( sampler2D shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord ) {
			float shadow = 1.0;
			shadowCoord.xyz /= shadowCoord.w;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				shadowCoord.z -= shadowBias;
			#else
				shadowCoord.z += shadowBias;
			#endif
			bool inFrustum = shadowCoord.x >= 0.0 && shadowCoord.x <= 1.0 && shadowCoord.y >= 0.0 && shadowCoord.y <= 1.0;
			bool frustumTest = inFrustum && shadowCoord.z <= 1.0;
			if ( frustumTest ) {
				float depth = texture2D( shadowMap, shadowCoord.xy ).r;
				#ifdef USE_REVERSED_DEPTH_BUFFER
					shadow = step( depth, shadowCoord.z );
				#else
					shadow = step( shadowCoord.z, depth );
				#endif
			}
			return mix( 1.0, shadow, shadowIntensity );
		}
	#endif
	#if NUM_SUN_LIGHT_SHADOWS > 0
		float getSunShadow(
			#if defined( SHADOWMAP_TYPE_PCF )
				sampler2DShadow shadowMap,
			#else
				sampler2D shadowMap,
			#endif
			SunLightShadow sunLightShadow,
			int shadowIndex
		) {
			vec4 shadowWorldPosition = vec4( vSunShadowWorldPosition.xyz + vSunShadowWorldNormal * sunLightShadow.shadowNormalBias, 1.0 );
			float viewDepth = vSunShadowWorldPosition.w;
			int cascadeOffset = shadowIndex * SUN_LIGHT_CASCADES;
			float shadow = 1.0;
			for ( int i = SUN_LIGHT_CASCADES - 1; i >= 0; i -- ) {
				vec4 cascade = sunShadowCascade[ cascadeOffset + i ];
				if ( viewDepth >= cascade.x && viewDepth < cascade.y ) {
					float cascadeShadow = getShadow(
						shadowMap,
						sunLightShadow.shadowMapSize,
						sunLightShadow.shadowIntensity,
						sunLightShadow.shadowBias,
						sunLightShadow.shadowRadius,
						sunShadowMatrix[ cascadeOffset + i ] * shadowWorldPosition
					);
					shadow = mix( cascadeShadow, shadow, smoothstep( cascade.z, cascade.y, viewDepth ) );
				}
			}
			return shadow;
		}
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
	#if defined( SHADOWMAP_TYPE_PCF )
	float getPointShadow( samplerCubeShadow shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord, float shadowCameraNear, float shadowCameraFar ) {
		float shadow = 1.0;
		vec3 lightToPosition = shadowCoord.xyz;
		vec3 bd3D = normalize( lightToPosition );
		vec3 absVec = abs( lightToPosition );
		float viewSpaceZ = max( max( absVec.x, absVec.y ), absVec.z );
		if ( viewSpaceZ - shadowCameraFar <= 0.0 && viewSpaceZ - shadowCameraNear >= 0.0 ) {
			float lightDistance = length( lightToPosition );
			float depthRange = shadowCameraFar - shadowCameraNear;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				float depthA = - shadowCameraNear / depthRange - shadowBias;
				float depthB = shadowCameraNear * shadowCameraFar / ( depthRange * lightDistance );
			#else
				float depthA = shadowCameraFar / depthRange + shadowBias;
				float depthB = - shadowCameraNear * shadowCameraFar / ( depthRange * lightDistance );
			#endif
			float texelSize = shadowRadius / shadowMapSize.x;
			vec3 absDir = abs( bd3D );
			vec3 tangent = absDir.x > absDir.z ? vec3( 0.0, 1.0, 0.0 ) : vec3( 1.0, 0.0, 0.0 );
			tangent = normalize( cross( bd3D, tangent ) );
			vec3 bitangent = cross( bd3D, tangent );
			float phi = interleavedGradientNoise( gl_FragCoord.xy ) * PI2;
			shadow = 0.0;
			for ( int i = 0; i < 5; i ++ ) {
				vec2 offset = vogelDiskSample( i, 5, phi );
				vec3 direction = bd3D + ( tangent * offset.x + bitangent * offset.y ) * texelSize;
				vec3 absDirection = abs( direction );
				float dp = depthA + depthB / max( max( absDirection.x, absDirection.y ), absDirection.z );
				shadow += texture( shadowMap, vec4( direction, dp ) );
			}
			shadow *= 0.2;
		}
		return mix( 1.0, shadow, shadowIntensity );
	}
	#elif defined( SHADOWMAP_TYPE_BASIC )
	float getPointShadow( samplerCube shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord, float shadowCameraNear, float shadowCameraFar ) {
		float shadow = 1.0;
		vec3 lightToPosition = shadowCoord.xyz;
		vec3 absVec = abs( lightToPosition );
		float viewSpaceZ = max( max( absVec.x, absVec.y ), absVec.z );
		if ( viewSpaceZ - shadowCameraFar <= 0.0 && viewSpaceZ - shadowCameraNear >= 0.0 ) {
			float dp = ( shadowCameraFar * ( viewSpaceZ - shadowCameraNear ) ) / ( viewSpaceZ * ( shadowCameraFar - shadowCameraNear ) );
			dp += shadowBias;
			vec3 bd3D = normalize( lightToPosition );
			float depth = textureCube( shadowMap, bd3D ).r;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				depth = 1.0 - depth;
			#endif
			shadow = step( dp, depth );
		}
		return mix( 1.0, shadow, shadowIntensity );
	}
	#endif
	#endif
#endif`,FM=`#if NUM_SPOT_LIGHT_COORDS > 0
	uniform mat4 spotLightMatrix[ NUM_SPOT_LIGHT_COORDS ];
	varying vec4 vSpotLightCoord[ NUM_SPOT_LIGHT_COORDS ];
#endif
#ifdef USE_SHADOWMAP
	#if NUM_SUN_LIGHT_SHADOWS > 0
		varying vec4 vSunShadowWorldPosition;
		varying vec3 vSunShadowWorldNormal;
	#endif
	#if NUM_DIR_LIGHT_SHADOWS > 0
		uniform mat4 directionalShadowMatrix[ NUM_DIR_LIGHT_SHADOWS ];
		varying vec4 vDirectionalShadowCoord[ NUM_DIR_LIGHT_SHADOWS ];
		struct DirectionalLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform DirectionalLightShadow directionalLightShadows[ NUM_DIR_LIGHT_SHADOWS ];
	#endif
	#if NUM_SPOT_LIGHT_SHADOWS > 0
		struct SpotLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform SpotLightShadow spotLightShadows[ NUM_SPOT_LIGHT_SHADOWS ];
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
		uniform mat4 pointShadowMatrix[ NUM_POINT_LIGHT_SHADOWS ];
		varying vec4 vPointShadowCoord[ NUM_POINT_LIGHT_SHADOWS ];
		struct PointLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
			float shadowCameraNear;
			float shadowCameraFar;
		};
		uniform PointLightShadow pointLightShadows[ NUM_POINT_LIGHT_SHADOWS ];
	#endif
#endif`,OM=`#if ( defined( USE_SHADOWMAP ) && ( NUM_DIR_LIGHT_SHADOWS > 0 || NUM_SUN_LIGHT_SHADOWS > 0 || NUM_POINT_LIGHT_SHADOWS > 0 ) ) || ( NUM_SPOT_LIGHT_COORDS > 0 )
	#ifdef HAS_NORMAL
		vec3 shadowWorldNormal = transformNormalByInverseViewMatrix( transformedNormal, viewMatrix );
	#else
		vec3 shadowWorldNormal = vec3( 0.0 );
	#endif
	vec4 shadowWorldPosition;
#endif
#if defined( USE_SHADOWMAP )
	#if NUM_SUN_LIGHT_SHADOWS > 0
		vSunShadowWorldPosition = vec4( worldPosition.xyz, - mvPosition.z );
		vSunShadowWorldNormal = shadowWorldNormal;
	#endif
	#if NUM_DIR_LIGHT_SHADOWS > 0
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_DIR_LIGHT_SHADOWS; i ++ ) {
			shadowWorldPosition = worldPosition + vec4( shadowWorldNormal * directionalLightShadows[ i ].shadowNormalBias, 0 );
			vDirectionalShadowCoord[ i ] = directionalShadowMatrix[ i ] * shadowWorldPosition;
		}
		#pragma unroll_loop_end
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_POINT_LIGHT_SHADOWS; i ++ ) {
			shadowWorldPosition = worldPosition + vec4( shadowWorldNormal * pointLightShadows[ i ].shadowNormalBias, 0 );
			vPointShadowCoord[ i ] = pointShadowMatrix[ i ] * shadowWorldPosition;
		}
		#pragma unroll_loop_end
	#endif
#endif
#if NUM_SPOT_LIGHT_COORDS > 0
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SPOT_LIGHT_COORDS; i ++ ) {
		shadowWorldPosition = worldPosition;
		#if ( defined( USE_SHADOWMAP ) && UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS )
			shadowWorldPosition.xyz += shadowWorldNormal * spotLightShadows[ i ].shadowNormalBias;
		#endif
		vSpotLightCoord[ i ] = spotLightMatrix[ i ] * shadowWorldPosition;
	}
	#pragma unroll_loop_end
#endif`,BM=`float getShadowMask() {
	float shadow = 1.0;
	#ifdef USE_SHADOWMAP
	#if NUM_SUN_LIGHT_SHADOWS > 0
	SunLightShadow sunLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SUN_LIGHT_SHADOWS; i ++ ) {
		sunLight = sunLightShadows[ i ];
		shadow *= receiveShadow ? getSunShadow( sunShadowMap[ i ], sunLight, UNROLLED_LOOP_INDEX ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#if NUM_DIR_LIGHT_SHADOWS > 0
	DirectionalLightShadow directionalLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_DIR_LIGHT_SHADOWS; i ++ ) {
		directionalLight = directionalLightShadows[ i ];
		shadow *= receiveShadow ? getShadow( directionalShadowMap[ i ], directionalLight.shadowMapSize, directionalLight.shadowIntensity, directionalLight.shadowBias, directionalLight.shadowRadius, vDirectionalShadowCoord[ i ] ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#if NUM_SPOT_LIGHT_SHADOWS > 0
	SpotLightShadow spotLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SPOT_LIGHT_SHADOWS; i ++ ) {
		spotLight = spotLightShadows[ i ];
		shadow *= receiveShadow ? getShadow( spotShadowMap[ i ], spotLight.shadowMapSize, spotLight.shadowIntensity, spotLight.shadowBias, spotLight.shadowRadius, vSpotLightCoord[ i ] ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0 && ( defined( SHADOWMAP_TYPE_PCF ) || defined( SHADOWMAP_TYPE_BASIC ) )
	PointLightShadow pointLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_POINT_LIGHT_SHADOWS; i ++ ) {
		pointLight = pointLightShadows[ i ];
		shadow *= receiveShadow ? getPointShadow( pointShadowMap[ i ], pointLight.shadowMapSize, pointLight.shadowIntensity, pointLight.shadowBias, pointLight.shadowRadius, vPointShadowCoord[ i ], pointLight.shadowCameraNear, pointLight.shadowCameraFar ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#endif
	return shadow;
}`,kM=`#ifdef USE_SKINNING
	mat4 boneMatX = getBoneMatrix( skinIndex.x );
	mat4 boneMatY = getBoneMatrix( skinIndex.y );
	mat4 boneMatZ = getBoneMatrix( skinIndex.z );
	mat4 boneMatW = getBoneMatrix( skinIndex.w );
#endif`,zM=`#ifdef USE_SKINNING
	uniform mat4 bindMatrix;
	uniform mat4 bindMatrixInverse;
	uniform highp sampler2D boneTexture;
	mat4 getBoneMatrix( const in float i ) {
		int size = textureSize( boneTexture, 0 ).x;
		int j = int( i ) * 4;
		int x = j % size;
		int y = j / size;
		vec4 v1 = texelFetch( boneTexture, ivec2( x, y ), 0 );
		vec4 v2 = texelFetch( boneTexture, ivec2( x + 1, y ), 0 );
		vec4 v3 = texelFetch( boneTexture, ivec2( x + 2, y ), 0 );
		vec4 v4 = texelFetch( boneTexture, ivec2( x + 3, y ), 0 );
		return mat4( v1, v2, v3, v4 );
	}
#endif`,VM=`#ifdef USE_SKINNING
	vec4 skinVertex = bindMatrix * vec4( transformed, 1.0 );
	vec4 skinned = vec4( 0.0 );
	skinned += boneMatX * skinVertex * skinWeight.x;
	skinned += boneMatY * skinVertex * skinWeight.y;
	skinned += boneMatZ * skinVertex * skinWeight.z;
	skinned += boneMatW * skinVertex * skinWeight.w;
	transformed = ( bindMatrixInverse * skinned ).xyz;
#endif`,GM=`#ifdef USE_SKINNING
	mat4 skinMatrix = mat4( 0.0 );
	skinMatrix += skinWeight.x * boneMatX;
	skinMatrix += skinWeight.y * boneMatY;
	skinMatrix += skinWeight.z * boneMatZ;
	skinMatrix += skinWeight.w * boneMatW;
	skinMatrix = bindMatrixInverse * skinMatrix * bindMatrix;
	objectNormal = vec4( skinMatrix * vec4( objectNormal, 0.0 ) ).xyz;
	#ifdef USE_TANGENT
		objectTangent = vec4( skinMatrix * vec4( objectTangent, 0.0 ) ).xyz;
	#endif
#endif`,HM=`float specularStrength;
#ifdef USE_SPECULARMAP
	vec4 texelSpecular = texture2D( specularMap, vSpecularMapUv );
	specularStrength = texelSpecular.r;
#else
	specularStrength = 1.0;
#endif`,WM=`#ifdef USE_SPECULARMAP
	uniform sampler2D specularMap;
#endif`,XM=`#if defined( TONE_MAPPING )
	gl_FragColor.rgb = toneMapping( gl_FragColor.rgb );
#endif`,qM=`#ifndef saturate
#define saturate( a ) clamp( a, 0.0, 1.0 )
#endif
uniform float toneMappingExposure;
vec3 LinearToneMapping( vec3 color ) {
	return saturate( toneMappingExposure * color );
}
vec3 ReinhardToneMapping( vec3 color ) {
	color *= toneMappingExposure;
	return saturate( color / ( vec3( 1.0 ) + color ) );
}
vec3 CineonToneMapping( vec3 color ) {
	color *= toneMappingExposure;
	color = max( vec3( 0.0 ), color - 0.004 );
	return pow( ( color * ( 6.2 * color + 0.5 ) ) / ( color * ( 6.2 * color + 1.7 ) + 0.06 ), vec3( 2.2 ) );
}
vec3 RRTAndODTFit( vec3 v ) {
	vec3 a = v * ( v + 0.0245786 ) - 0.000090537;
	vec3 b = v * ( 0.983729 * v + 0.4329510 ) + 0.238081;
	return a / b;
}
vec3 ACESFilmicToneMapping( vec3 color ) {
	const mat3 ACESInputMat = mat3(
		vec3( 0.59719, 0.07600, 0.02840 ),		vec3( 0.35458, 0.90834, 0.13383 ),
		vec3( 0.04823, 0.01566, 0.83777 )
	);
	const mat3 ACESOutputMat = mat3(
		vec3(  1.60475, -0.10208, -0.00327 ),		vec3( -0.53108,  1.10813, -0.07276 ),
		vec3( -0.07367, -0.00605,  1.07602 )
	);
	color *= toneMappingExposure / 0.6;
	color = ACESInputMat * color;
	color = RRTAndODTFit( color );
	color = ACESOutputMat * color;
	return saturate( color );
}
const mat3 LINEAR_REC2020_TO_LINEAR_SRGB = mat3(
	vec3( 1.6605, - 0.1246, - 0.0182 ),
	vec3( - 0.5876, 1.1329, - 0.1006 ),
	vec3( - 0.0728, - 0.0083, 1.1187 )
);
const mat3 LINEAR_SRGB_TO_LINEAR_REC2020 = mat3(
	vec3( 0.6274, 0.0691, 0.0164 ),
	vec3( 0.3293, 0.9195, 0.0880 ),
	vec3( 0.0433, 0.0113, 0.8956 )
);
vec3 agxDefaultContrastApprox( vec3 x ) {
	vec3 x2 = x * x;
	vec3 x4 = x2 * x2;
	return + 15.5 * x4 * x2
		- 40.14 * x4 * x
		+ 31.96 * x4
		- 6.868 * x2 * x
		+ 0.4298 * x2
		+ 0.1191 * x
		- 0.00232;
}
vec3 AgXToneMapping( vec3 color ) {
	const mat3 AgXInsetMatrix = mat3(
		vec3( 0.856627153315983, 0.137318972929847, 0.11189821299995 ),
		vec3( 0.0951212405381588, 0.761241990602591, 0.0767994186031903 ),
		vec3( 0.0482516061458583, 0.101439036467562, 0.811302368396859 )
	);
	const mat3 AgXOutsetMatrix = mat3(
		vec3( 1.1271005818144368, - 0.1413297634984383, - 0.14132976349843826 ),
		vec3( - 0.11060664309660323, 1.157823702216272, - 0.11060664309660294 ),
		vec3( - 0.016493938717834573, - 0.016493938717834257, 1.2519364065950405 )
	);
	const float AgxMinEv = - 12.47393;	const float AgxMaxEv = 4.026069;
	color *= toneMappingExposure;
	color = LINEAR_SRGB_TO_LINEAR_REC2020 * color;
	color = AgXInsetMatrix * color;
	color = max( color, 1e-10 );	color = log2( color );
	color = ( color - AgxMinEv ) / ( AgxMaxEv - AgxMinEv );
	color = clamp( color, 0.0, 1.0 );
	color = agxDefaultContrastApprox( color );
	color = AgXOutsetMatrix * color;
	color = pow( max( vec3( 0.0 ), color ), vec3( 2.2 ) );
	color = LINEAR_REC2020_TO_LINEAR_SRGB * color;
	color = clamp( color, 0.0, 1.0 );
	return color;
}
vec3 NeutralToneMapping( vec3 color ) {
	const float StartCompression = 0.8 - 0.04;
	const float Desaturation = 0.15;
	color *= toneMappingExposure;
	float x = min( color.r, min( color.g, color.b ) );
	float offset = x < 0.08 ? x - 6.25 * x * x : 0.04;
	color -= offset;
	float peak = max( color.r, max( color.g, color.b ) );
	if ( peak < StartCompression ) return color;
	float d = 1. - StartCompression;
	float newPeak = 1. - d * d / ( peak + d - StartCompression );
	color *= newPeak / peak;
	float g = 1. - 1. / ( Desaturation * ( peak - newPeak ) + 1. );
	return mix( color, vec3( newPeak ), g );
}
vec3 CustomToneMapping( vec3 color ) { return color; }`,$M=`#ifdef USE_TRANSMISSION
	material.transmission = transmission;
	material.transmissionAlpha = 1.0;
	material.thickness = thickness;
	material.attenuationDistance = attenuationDistance;
	material.attenuationColor = attenuationColor;
	#ifdef USE_TRANSMISSIONMAP
		material.transmission *= texture2D( transmissionMap, vTransmissionMapUv ).r;
	#endif
	#ifdef USE_THICKNESSMAP
		material.thickness *= texture2D( thicknessMap, vThicknessMapUv ).g;
	#endif
	vec3 pos = vWorldPosition;
	vec3 v = normalize( cameraPosition - pos );
	vec3 n = transformNormalByInverseViewMatrix( normal, viewMatrix );
	vec4 transmitted = getIBLVolumeRefraction(
		n, v, material.roughness, material.diffuseContribution, material.specularColorBlended, material.specularF90,
		pos, modelMatrix, viewMatrix, projectionMatrix, material.dispersion, material.ior, material.thickness,
		material.attenuationColor, material.attenuationDistance );
	material.transmissionAlpha = mix( material.transmissionAlpha, transmitted.a, material.transmission );
	totalDiffuse = mix( totalDiffuse, transmitted.rgb, material.transmission );
#endif`,YM=`#ifdef USE_TRANSMISSION
	uniform float transmission;
	uniform float thickness;
	uniform float attenuationDistance;
	uniform vec3 attenuationColor;
	#ifdef USE_TRANSMISSIONMAP
		uniform sampler2D transmissionMap;
	#endif
	#ifdef USE_THICKNESSMAP
		uniform sampler2D thicknessMap;
	#endif
	uniform vec2 transmissionSamplerSize;
	uniform sampler2D transmissionSamplerMap;
	uniform mat4 modelMatrix;
	uniform mat4 projectionMatrix;
	varying vec3 vWorldPosition;
	float w0( float a ) {
		return ( 1.0 / 6.0 ) * ( a * ( a * ( - a + 3.0 ) - 3.0 ) + 1.0 );
	}
	float w1( float a ) {
		return ( 1.0 / 6.0 ) * ( a *  a * ( 3.0 * a - 6.0 ) + 4.0 );
	}
	float w2( float a ){
		return ( 1.0 / 6.0 ) * ( a * ( a * ( - 3.0 * a + 3.0 ) + 3.0 ) + 1.0 );
	}
	float w3( float a ) {
		return ( 1.0 / 6.0 ) * ( a * a * a );
	}
	float g0( float a ) {
		return w0( a ) + w1( a );
	}
	float g1( float a ) {
		return w2( a ) + w3( a );
	}
	float h0( float a ) {
		return - 1.0 + w1( a ) / ( w0( a ) + w1( a ) );
	}
	float h1( float a ) {
		return 1.0 + w3( a ) / ( w2( a ) + w3( a ) );
	}
	vec4 bicubic( sampler2D tex, vec2 uv, vec4 texelSize, float lod ) {
		uv = uv * texelSize.zw + 0.5;
		vec2 iuv = floor( uv );
		vec2 fuv = fract( uv );
		float g0x = g0( fuv.x );
		float g1x = g1( fuv.x );
		float h0x = h0( fuv.x );
		float h1x = h1( fuv.x );
		float h0y = h0( fuv.y );
		float h1y = h1( fuv.y );
		vec2 p0 = ( vec2( iuv.x + h0x, iuv.y + h0y ) - 0.5 ) * texelSize.xy;
		vec2 p1 = ( vec2( iuv.x + h1x, iuv.y + h0y ) - 0.5 ) * texelSize.xy;
		vec2 p2 = ( vec2( iuv.x + h0x, iuv.y + h1y ) - 0.5 ) * texelSize.xy;
		vec2 p3 = ( vec2( iuv.x + h1x, iuv.y + h1y ) - 0.5 ) * texelSize.xy;
		return g0( fuv.y ) * ( g0x * textureLod( tex, p0, lod ) + g1x * textureLod( tex, p1, lod ) ) +
			g1( fuv.y ) * ( g0x * textureLod( tex, p2, lod ) + g1x * textureLod( tex, p3, lod ) );
	}
	vec4 textureBicubic( sampler2D sampler, vec2 uv, float lod ) {
		vec2 fLodSize = vec2( textureSize( sampler, int( lod ) ) );
		vec2 cLodSize = vec2( textureSize( sampler, int( lod + 1.0 ) ) );
		vec2 fLodSizeInv = 1.0 / fLodSize;
		vec2 cLodSizeInv = 1.0 / cLodSize;
		vec4 fSample = bicubic( sampler, uv, vec4( fLodSizeInv, fLodSize ), floor( lod ) );
		vec4 cSample = bicubic( sampler, uv, vec4( cLodSizeInv, cLodSize ), ceil( lod ) );
		return mix( fSample, cSample, fract( lod ) );
	}
	vec3 getVolumeTransmissionRay( const in vec3 n, const in vec3 v, const in float thickness, const in float ior, const in mat4 modelMatrix ) {
		vec3 refractionVector = refract( - v, normalize( n ), 1.0 / ior );
		vec3 modelScale;
		modelScale.x = length( vec3( modelMatrix[ 0 ].xyz ) );
		modelScale.y = length( vec3( modelMatrix[ 1 ].xyz ) );
		modelScale.z = length( vec3( modelMatrix[ 2 ].xyz ) );
		return normalize( refractionVector ) * thickness * modelScale;
	}
	float applyIorToRoughness( const in float roughness, const in float ior ) {
		return roughness * clamp( ior * 2.0 - 2.0, 0.0, 1.0 );
	}
	vec4 getTransmissionSample( const in vec2 fragCoord, const in float roughness, const in float ior ) {
		float lod = log2( transmissionSamplerSize.x ) * applyIorToRoughness( roughness, ior );
		return textureBicubic( transmissionSamplerMap, fragCoord.xy, lod );
	}
	vec3 volumeAttenuation( const in float transmissionDistance, const in vec3 attenuationColor, const in float attenuationDistance ) {
		if ( isinf( attenuationDistance ) ) {
			return vec3( 1.0 );
		} else {
			vec3 attenuationCoefficient = -log( attenuationColor ) / attenuationDistance;
			vec3 transmittance = exp( - attenuationCoefficient * transmissionDistance );			return transmittance;
		}
	}
	vec4 getIBLVolumeRefraction( const in vec3 n, const in vec3 v, const in float roughness, const in vec3 diffuseColor,
		const in vec3 specularColor, const in float specularF90, const in vec3 position, const in mat4 modelMatrix,
		const in mat4 viewMatrix, const in mat4 projMatrix, const in float dispersion, const in float ior, const in float thickness,
		const in vec3 attenuationColor, const in float attenuationDistance ) {
		vec4 transmittedLight;
		vec3 transmittance;
		#ifdef USE_DISPERSION
			float halfSpread = ( ior - 1.0 ) * 0.025 * dispersion;
			vec3 iors = vec3( ior - halfSpread, ior, ior + halfSpread );
			for ( int i = 0; i < 3; i ++ ) {
				vec3 transmissionRay = getVolumeTransmissionRay( n, v, thickness, iors[ i ], modelMatrix );
				vec3 refractedRayExit = position + transmissionRay;
				vec4 ndcPos = projMatrix * viewMatrix * vec4( refractedRayExit, 1.0 );
				vec2 refractionCoords = ndcPos.xy / ndcPos.w;
				refractionCoords += 1.0;
				refractionCoords /= 2.0;
				vec4 transmissionSample = getTransmissionSample( refractionCoords, roughness, iors[ i ] );
				transmittedLight[ i ] = transmissionSample[ i ];
				transmittedLight.a += transmissionSample.a;
				transmittance[ i ] = diffuseColor[ i ] * volumeAttenuation( length( transmissionRay ), attenuationColor, attenuationDistance )[ i ];
			}
			transmittedLight.a /= 3.0;
		#else
			vec3 transmissionRay = getVolumeTransmissionRay( n, v, thickness, ior, modelMatrix );
			vec3 refractedRayExit = position + transmissionRay;
			vec4 ndcPos = projMatrix * viewMatrix * vec4( refractedRayExit, 1.0 );
			vec2 refractionCoords = ndcPos.xy / ndcPos.w;
			refractionCoords += 1.0;
			refractionCoords /= 2.0;
			transmittedLight = getTransmissionSample( refractionCoords, roughness, ior );
			transmittance = diffuseColor * volumeAttenuation( length( transmissionRay ), attenuationColor, attenuationDistance );
		#endif
		vec3 attenuatedColor = transmittance * transmittedLight.rgb;
		vec3 F = EnvironmentBRDF( n, v, specularColor, specularF90, roughness );
		float transmittanceFactor = ( transmittance.r + transmittance.g + transmittance.b ) / 3.0;
		return vec4( ( 1.0 - F ) * attenuatedColor, 1.0 - ( 1.0 - transmittedLight.a ) * transmittanceFactor );
	}
#endif`,ZM=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
	varying vec2 vUv;
#endif
#ifdef USE_MAP
	varying vec2 vMapUv;
#endif
#ifdef USE_ALPHAMAP
	varying vec2 vAlphaMapUv;
#endif
#ifdef USE_LIGHTMAP
	varying vec2 vLightMapUv;
#endif
#ifdef USE_AOMAP
	varying vec2 vAoMapUv;
#endif
#ifdef USE_BUMPMAP
	varying vec2 vBumpMapUv;
#endif
#ifdef USE_NORMALMAP
	varying vec2 vNormalMapUv;
#endif
#ifdef USE_EMISSIVEMAP
	varying vec2 vEmissiveMapUv;
#endif
#ifdef USE_METALNESSMAP
	varying vec2 vMetalnessMapUv;
#endif
#ifdef USE_ROUGHNESSMAP
	varying vec2 vRoughnessMapUv;
#endif
#ifdef USE_DIFFUSE_ROUGHNESSMAP
	varying vec2 vDiffuseRoughnessMapUv;
#endif
#ifdef USE_ANISOTROPYMAP
	varying vec2 vAnisotropyMapUv;
#endif
#ifdef USE_CLEARCOATMAP
	varying vec2 vClearcoatMapUv;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	varying vec2 vClearcoatNormalMapUv;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	varying vec2 vClearcoatRoughnessMapUv;
#endif
#ifdef USE_IRIDESCENCEMAP
	varying vec2 vIridescenceMapUv;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	varying vec2 vIridescenceThicknessMapUv;
#endif
#ifdef USE_SHEEN_COLORMAP
	varying vec2 vSheenColorMapUv;
#endif
#ifdef USE_SHEEN_ROUGHNESSMAP
	varying vec2 vSheenRoughnessMapUv;
#endif
#ifdef USE_SPECULARMAP
	varying vec2 vSpecularMapUv;
#endif
#ifdef USE_SPECULAR_COLORMAP
	varying vec2 vSpecularColorMapUv;
#endif
#ifdef USE_SPECULAR_INTENSITYMAP
	varying vec2 vSpecularIntensityMapUv;
#endif
#ifdef USE_TRANSMISSIONMAP
	uniform mat3 transmissionMapTransform;
	varying vec2 vTransmissionMapUv;
#endif
#ifdef USE_THICKNESSMAP
	uniform mat3 thicknessMapTransform;
	varying vec2 vThicknessMapUv;
#endif`,JM=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
	varying vec2 vUv;
#endif
#ifdef USE_MAP
	uniform mat3 mapTransform;
	varying vec2 vMapUv;
#endif
#ifdef USE_ALPHAMAP
	uniform mat3 alphaMapTransform;
	varying vec2 vAlphaMapUv;
#endif
#ifdef USE_LIGHTMAP
	uniform mat3 lightMapTransform;
	varying vec2 vLightMapUv;
#endif
#ifdef USE_AOMAP
	uniform mat3 aoMapTransform;
	varying vec2 vAoMapUv;
#endif
#ifdef USE_BUMPMAP
	uniform mat3 bumpMapTransform;
	varying vec2 vBumpMapUv;
#endif
#ifdef USE_NORMALMAP
	uniform mat3 normalMapTransform;
	varying vec2 vNormalMapUv;
#endif
#ifdef USE_DISPLACEMENTMAP
	uniform mat3 displacementMapTransform;
	varying vec2 vDisplacementMapUv;
#endif
#ifdef USE_EMISSIVEMAP
	uniform mat3 emissiveMapTransform;
	varying vec2 vEmissiveMapUv;
#endif
#ifdef USE_METALNESSMAP
	uniform mat3 metalnessMapTransform;
	varying vec2 vMetalnessMapUv;
#endif
#ifdef USE_ROUGHNESSMAP
	uniform mat3 roughnessMapTransform;
	varying vec2 vRoughnessMapUv;
#endif
#ifdef USE_DIFFUSE_ROUGHNESSMAP
	uniform mat3 diffuseRoughnessMapTransform;
	varying vec2 vDiffuseRoughnessMapUv;
#endif
#ifdef USE_ANISOTROPYMAP
	uniform mat3 anisotropyMapTransform;
	varying vec2 vAnisotropyMapUv;
#endif
#ifdef USE_CLEARCOATMAP
	uniform mat3 clearcoatMapTransform;
	varying vec2 vClearcoatMapUv;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	uniform mat3 clearcoatNormalMapTransform;
	varying vec2 vClearcoatNormalMapUv;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	uniform mat3 clearcoatRoughnessMapTransform;
	varying vec2 vClearcoatRoughnessMapUv;
#endif
#ifdef USE_SHEEN_COLORMAP
	uniform mat3 sheenColorMapTransform;
	varying vec2 vSheenColorMapUv;
#endif
#ifdef USE_SHEEN_ROUGHNESSMAP
	uniform mat3 sheenRoughnessMapTransform;
	varying vec2 vSheenRoughnessMapUv;
#endif
#ifdef USE_IRIDESCENCEMAP
	uniform mat3 iridescenceMapTransform;
	varying vec2 vIridescenceMapUv;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	uniform mat3 iridescenceThicknessMapTransform;
	varying vec2 vIridescenceThicknessMapUv;
#endif
#ifdef USE_SPECULARMAP
	uniform mat3 specularMapTransform;
	varying vec2 vSpecularMapUv;
#endif
#ifdef USE_SPECULAR_COLORMAP
	uniform mat3 specularColorMapTransform;
	varying vec2 vSpecularColorMapUv;
#endif
#ifdef USE_SPECULAR_INTENSITYMAP
	uniform mat3 specularIntensityMapTransform;
	varying vec2 vSpecularIntensityMapUv;
#endif
#ifdef USE_TRANSMISSIONMAP
	uniform mat3 transmissionMapTransform;
	varying vec2 vTransmissionMapUv;
#endif
#ifdef USE_THICKNESSMAP
	uniform mat3 thicknessMapTransform;
	varying vec2 vThicknessMapUv;
#endif`,KM=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
	vUv = vec3( uv, 1 ).xy;
#endif
#ifdef USE_MAP
	vMapUv = ( mapTransform * vec3( MAP_UV, 1 ) ).xy;
#endif
#ifdef USE_ALPHAMAP
	vAlphaMapUv = ( alphaMapTransform * vec3( ALPHAMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_LIGHTMAP
	vLightMapUv = ( lightMapTransform * vec3( LIGHTMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_AOMAP
	vAoMapUv = ( aoMapTransform * vec3( AOMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_BUMPMAP
	vBumpMapUv = ( bumpMapTransform * vec3( BUMPMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_NORMALMAP
	vNormalMapUv = ( normalMapTransform * vec3( NORMALMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_DISPLACEMENTMAP
	vDisplacementMapUv = ( displacementMapTransform * vec3( DISPLACEMENTMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_EMISSIVEMAP
	vEmissiveMapUv = ( emissiveMapTransform * vec3( EMISSIVEMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_METALNESSMAP
	vMetalnessMapUv = ( metalnessMapTransform * vec3( METALNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_ROUGHNESSMAP
	vRoughnessMapUv = ( roughnessMapTransform * vec3( ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_DIFFUSE_ROUGHNESSMAP
	vDiffuseRoughnessMapUv = ( diffuseRoughnessMapTransform * vec3( DIFFUSE_ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_ANISOTROPYMAP
	vAnisotropyMapUv = ( anisotropyMapTransform * vec3( ANISOTROPYMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_CLEARCOATMAP
	vClearcoatMapUv = ( clearcoatMapTransform * vec3( CLEARCOATMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	vClearcoatNormalMapUv = ( clearcoatNormalMapTransform * vec3( CLEARCOAT_NORMALMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	vClearcoatRoughnessMapUv = ( clearcoatRoughnessMapTransform * vec3( CLEARCOAT_ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_IRIDESCENCEMAP
	vIridescenceMapUv = ( iridescenceMapTransform * vec3( IRIDESCENCEMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	vIridescenceThicknessMapUv = ( iridescenceThicknessMapTransform * vec3( IRIDESCENCE_THICKNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SHEEN_COLORMAP
	vSheenColorMapUv = ( sheenColorMapTransform * vec3( SHEEN_COLORMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SHEEN_ROUGHNESSMAP
	vSheenRoughnessMapUv = ( sheenRoughnessMapTransform * vec3( SHEEN_ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SPECULARMAP
	vSpecularMapUv = ( specularMapTransform * vec3( SPECULARMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SPECULAR_COLORMAP
	vSpecularColorMapUv = ( specularColorMapTransform * vec3( SPECULAR_COLORMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SPECULAR_INTENSITYMAP
	vSpecularIntensityMapUv = ( specularIntensityMapTransform * vec3( SPECULAR_INTENSITYMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_TRANSMISSIONMAP
	vTransmissionMapUv = ( transmissionMapTransform * vec3( TRANSMISSIONMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_THICKNESSMAP
	vThicknessMapUv = ( thicknessMapTransform * vec3( THICKNESSMAP_UV, 1 ) ).xy;
#endif`,jM=`#if defined( USE_ENVMAP ) || defined( DISTANCE ) || defined ( USE_SHADOWMAP ) || defined ( USE_TRANSMISSION ) || NUM_SPOT_LIGHT_COORDS > 0
	vec4 worldPosition = vec4( transformed, 1.0 );
	#ifdef USE_BATCHING
		worldPosition = batchingMatrix * worldPosition;
	#endif
	#ifdef USE_INSTANCING
		worldPosition = instanceMatrix * worldPosition;
	#endif
	worldPosition = modelMatrix * worldPosition;
#endif`,QM=`varying vec2 vUv;
uniform mat3 uvTransform;
void main() {
	vUv = ( uvTransform * vec3( uv, 1 ) ).xy;
	gl_Position = vec4( position.xy, 1.0, 1.0 );
}`,tb=`uniform sampler2D t2D;
uniform float backgroundIntensity;
varying vec2 vUv;
void main() {
	vec4 texColor = texture2D( t2D, vUv );
	#ifdef DECODE_VIDEO_TEXTURE
		texColor = vec4( mix( pow( texColor.rgb * 0.9478672986 + vec3( 0.0521327014 ), vec3( 2.4 ) ), texColor.rgb * 0.0773993808, vec3( lessThanEqual( texColor.rgb, vec3( 0.04045 ) ) ) ), texColor.w );
	#endif
	texColor.rgb *= backgroundIntensity;
	gl_FragColor = texColor;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,eb=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,nb=`uniform float backgroundBlurriness;
uniform float backgroundIntensity;
uniform mat3 backgroundRotation;
varying vec3 vWorldDirection;
#include <envmap_common_pars_fragment>
void main() {
	#ifdef ENVMAP_TYPE_PMREM
		vec4 texColor = textureLod( envMap, backgroundRotation * vWorldDirection, roughnessToMip( backgroundBlurriness ) );
	#else
		vec4 texColor = textureCube( envMap, backgroundRotation * vWorldDirection );
	#endif
	texColor.rgb *= backgroundIntensity;
	gl_FragColor = texColor;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,ib=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,sb=`uniform samplerCube tCube;
uniform float tFlip;
uniform float opacity;
varying vec3 vWorldDirection;
void main() {
	vec4 texColor = textureCube( tCube, vec3( tFlip * vWorldDirection.x, vWorldDirection.yz ) );
	gl_FragColor = texColor;
	gl_FragColor.a *= opacity;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,rb=`#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
varying vec2 vHighPrecisionZW;
void main() {
	#include <uv_vertex>
	#include <batching_vertex>
	#include <skinbase_vertex>
	#include <morphinstance_vertex>
	#ifdef USE_DISPLACEMENTMAP
		#include <beginnormal_vertex>
		#include <morphnormal_vertex>
		#include <skinnormal_vertex>
	#endif
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vHighPrecisionZW = gl_Position.zw;
}`,ob=`#if DEPTH_PACKING == 3200
	uniform float opacity;
#endif
#include <common>
#include <packing>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
varying vec2 vHighPrecisionZW;
void main() {
	vec4 diffuseColor = vec4( 1.0 );
	#include <clipping_planes_fragment>
	#if DEPTH_PACKING == 3200
		diffuseColor.a = opacity;
	#endif
	#include <map_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <logdepthbuf_fragment>
	#ifdef USE_REVERSED_DEPTH_BUFFER
		float fragCoordZ = vHighPrecisionZW[ 0 ] / vHighPrecisionZW[ 1 ];
	#else
		float fragCoordZ = 0.5 * vHighPrecisionZW[ 0 ] / vHighPrecisionZW[ 1 ] + 0.5;
	#endif
	#if DEPTH_PACKING == 3200
		gl_FragColor = vec4( vec3( 1.0 - fragCoordZ ), opacity );
	#elif DEPTH_PACKING == 3201
		gl_FragColor = packDepthToRGBA( fragCoordZ );
	#elif DEPTH_PACKING == 3202
		gl_FragColor = vec4( packDepthToRGB( fragCoordZ ), 1.0 );
	#elif DEPTH_PACKING == 3203
		gl_FragColor = vec4( packDepthToRG( fragCoordZ ), 0.0, 1.0 );
	#endif
}`,ab=`#define DISTANCE
varying vec3 vWorldPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <batching_vertex>
	#include <skinbase_vertex>
	#include <morphinstance_vertex>
	#ifdef USE_DISPLACEMENTMAP
		#include <beginnormal_vertex>
		#include <morphnormal_vertex>
		#include <skinnormal_vertex>
	#endif
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <worldpos_vertex>
	#include <clipping_planes_vertex>
	vWorldPosition = worldPosition.xyz;
}`,lb=`#define DISTANCE
uniform vec3 referencePosition;
uniform float nearDistance;
uniform float farDistance;
varying vec3 vWorldPosition;
#include <common>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( 1.0 );
	#include <clipping_planes_fragment>
	#include <map_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	float dist = length( vWorldPosition - referencePosition );
	dist = ( dist - nearDistance ) / ( farDistance - nearDistance );
	dist = saturate( dist );
	gl_FragColor = vec4( dist, 0.0, 0.0, 1.0 );
}`,cb=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
}`,hb=`uniform sampler2D tEquirect;
varying vec3 vWorldDirection;
#include <common>
void main() {
	vec3 direction = normalize( vWorldDirection );
	vec2 sampleUV = equirectUv( direction );
	gl_FragColor = texture2D( tEquirect, sampleUV );
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,ub=`uniform float scale;
attribute float lineDistance;
varying float vLineDistance;
#include <common>
#include <uv_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	vLineDistance = scale * lineDistance;
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <fog_vertex>
}`,fb=`uniform vec3 diffuse;
uniform float opacity;
uniform float dashSize;
uniform float totalSize;
varying float vLineDistance;
#include <common>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <fog_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	if ( mod( vLineDistance, totalSize ) > dashSize ) {
		discard;
	}
	vec3 outgoingLight = vec3( 0.0 );
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	outgoingLight = diffuseColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
}`,db=`#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <envmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#if defined ( USE_ENVMAP ) || defined ( USE_SKINNING )
		#include <beginnormal_vertex>
		#include <morphnormal_vertex>
		#include <skinbase_vertex>
		#include <skinnormal_vertex>
		#include <defaultnormal_vertex>
	#endif
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <worldpos_vertex>
	#include <envmap_vertex>
	#include <fog_vertex>
}`,pb=`uniform vec3 diffuse;
uniform float opacity;
#ifndef FLAT_SHADED
	varying vec3 vNormal;
#endif
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_pars_fragment>
#include <fog_pars_fragment>
#include <specularmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <specularmap_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	#ifdef USE_LIGHTMAP
		vec4 lightMapTexel = texture2D( lightMap, vLightMapUv );
		reflectedLight.indirectDiffuse += lightMapTexel.rgb * lightMapIntensity * RECIPROCAL_PI;
	#else
		reflectedLight.indirectDiffuse += vec3( 1.0 );
	#endif
	#include <aomap_fragment>
	reflectedLight.indirectDiffuse *= diffuseColor.rgb;
	vec3 outgoingLight = reflectedLight.indirectDiffuse;
	#include <envmap_fragment>
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,mb=`#define LAMBERT
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <envmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <envmap_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,gb=`#define LAMBERT
uniform vec3 diffuse;
uniform vec3 emissive;
uniform float opacity;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_pars_fragment>
#include <envmap_physical_pars_fragment>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_lambert_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <specularmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <specularmap_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_lambert_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 outgoingLight = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse + totalEmissiveRadiance;
	#include <envmap_fragment>
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,_b=`#define MATCAP
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <color_pars_vertex>
#include <displacementmap_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <fog_vertex>
	vViewPosition = - mvPosition.xyz;
}`,xb=`#define MATCAP
uniform vec3 diffuse;
uniform float opacity;
uniform sampler2D matcap;
varying vec3 vViewPosition;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <fog_pars_fragment>
#include <normal_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	vec3 viewDir = normalize( vViewPosition );
	vec3 x = normalize( vec3( viewDir.z, 0.0, - viewDir.x ) );
	vec3 y = cross( viewDir, x );
	vec2 uv = vec2( dot( x, normal ), dot( y, normal ) ) * 0.495 + 0.5;
	#ifdef USE_MATCAP
		vec4 matcapColor = texture2D( matcap, uv );
	#else
		vec4 matcapColor = vec4( vec3( mix( 0.2, 0.8, uv.y ) ), 1.0 );
	#endif
	vec3 outgoingLight = diffuseColor.rgb * matcapColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,yb=`#define NORMAL
#if defined( FLAT_SHADED ) || defined( USE_BUMPMAP ) || defined( USE_NORMALMAP_TANGENTSPACE )
	varying vec3 vViewPosition;
#endif
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphinstance_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
#if defined( FLAT_SHADED ) || defined( USE_BUMPMAP ) || defined( USE_NORMALMAP_TANGENTSPACE )
	vViewPosition = - mvPosition.xyz;
#endif
}`,vb=`#define NORMAL
uniform float opacity;
#if defined( FLAT_SHADED ) || defined( USE_BUMPMAP ) || defined( USE_NORMALMAP_TANGENTSPACE )
	varying vec3 vViewPosition;
#endif
#include <uv_pars_fragment>
#include <normal_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( 0.0, 0.0, 0.0, opacity );
	#include <clipping_planes_fragment>
	#include <logdepthbuf_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	gl_FragColor = vec4( normalize( normal ) * 0.5 + 0.5, diffuseColor.a );
	#ifdef OPAQUE
		gl_FragColor.a = 1.0;
	#endif
}`,Sb=`#define PHONG
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <envmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphinstance_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <envmap_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,Mb=`#define PHONG
uniform vec3 diffuse;
uniform vec3 emissive;
uniform vec3 specular;
uniform float shininess;
uniform float opacity;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_pars_fragment>
#include <envmap_physical_pars_fragment>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_phong_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <specularmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <specularmap_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_phong_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 outgoingLight = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse + reflectedLight.directSpecular + reflectedLight.indirectSpecular + totalEmissiveRadiance;
	#include <envmap_fragment>
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,bb=`#define STANDARD
varying vec3 vViewPosition;
#ifdef USE_TRANSMISSION
	varying vec3 vWorldPosition;
#endif
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
#ifdef USE_TRANSMISSION
	vWorldPosition = worldPosition.xyz;
#endif
}`,wb=`#define STANDARD
#ifdef PHYSICAL
	#define IOR
	#define USE_SPECULAR
#endif
uniform vec3 diffuse;
uniform vec3 emissive;
uniform float roughness;
uniform float metalness;
uniform float opacity;
#ifdef IOR
	uniform float ior;
#endif
#ifdef USE_SPECULAR
	uniform float specularIntensity;
	uniform vec3 specularColor;
	#ifdef USE_SPECULAR_COLORMAP
		uniform sampler2D specularColorMap;
	#endif
	#ifdef USE_SPECULAR_INTENSITYMAP
		uniform sampler2D specularIntensityMap;
	#endif
#endif
#ifdef USE_CLEARCOAT
	uniform float clearcoat;
	uniform float clearcoatRoughness;
#endif
#ifdef USE_DIFFUSE_ROUGHNESS
	uniform float diffuseRoughness;
	#ifdef USE_DIFFUSE_ROUGHNESSMAP
		uniform sampler2D diffuseRoughnessMap;
	#endif
#endif
#ifdef USE_DISPERSION
	uniform float dispersion;
#endif
#ifdef USE_RETROREFLECTION
	uniform float retroreflectivity;
#endif
#ifdef USE_IRIDESCENCE
	uniform float iridescence;
	uniform float iridescenceIOR;
	uniform float iridescenceThicknessMinimum;
	uniform float iridescenceThicknessMaximum;
#endif
#ifdef USE_SHEEN
	uniform vec3 sheenColor;
	uniform float sheenRoughness;
	#ifdef USE_SHEEN_COLORMAP
		uniform sampler2D sheenColorMap;
	#endif
	#ifdef USE_SHEEN_ROUGHNESSMAP
		uniform sampler2D sheenRoughnessMap;
	#endif
#endif
#ifdef USE_ANISOTROPY
	uniform vec2 anisotropyVector;
	#ifdef USE_ANISOTROPYMAP
		uniform sampler2D anisotropyMap;
	#endif
#endif
varying vec3 vViewPosition;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <iridescence_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_physical_pars_fragment>
#include <fog_pars_fragment>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_physical_pars_fragment>
#include <transmission_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <clearcoat_pars_fragment>
#include <iridescence_pars_fragment>
#include <roughnessmap_pars_fragment>
#include <metalnessmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <roughnessmap_fragment>
	#include <metalnessmap_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <clearcoat_normal_fragment_begin>
	#include <clearcoat_normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_physical_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 totalDiffuse = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse;
	vec3 totalSpecular = reflectedLight.directSpecular + reflectedLight.indirectSpecular;
	#include <transmission_fragment>
	vec3 outgoingLight = totalDiffuse + totalSpecular + totalEmissiveRadiance;
	#ifdef USE_SHEEN
 
		outgoingLight = outgoingLight + sheenSpecularDirect + sheenSpecularIndirect;
 
 	#endif
	#ifdef USE_CLEARCOAT
		float dotNVcc = saturate( dot( geometryClearcoatNormal, geometryViewDir ) );
		vec3 Fcc = F_Schlick( material.clearcoatF0, material.clearcoatF90, dotNVcc );
		outgoingLight = outgoingLight * ( 1.0 - material.clearcoat * Fcc ) + ( clearcoatSpecularDirect + clearcoatSpecularIndirect ) * material.clearcoat;
	#endif
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,Tb=`#define TOON
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,Eb=`#define TOON
uniform vec3 diffuse;
uniform vec3 emissive;
uniform float opacity;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <gradientmap_pars_fragment>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_toon_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_toon_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 outgoingLight = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse + totalEmissiveRadiance;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,Ab=`uniform float size;
uniform float scale;
#include <common>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
#ifdef USE_POINTS_UV
	varying vec2 vUv;
	uniform mat3 uvTransform;
#endif
void main() {
	#ifdef USE_POINTS_UV
		vUv = ( uvTransform * vec3( uv, 1 ) ).xy;
	#endif
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <project_vertex>
	gl_PointSize = size;
	#ifdef USE_SIZEATTENUATION
		bool isPerspective = isPerspectiveMatrix( projectionMatrix );
		if ( isPerspective ) gl_PointSize *= ( scale / - mvPosition.z );
	#endif
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <worldpos_vertex>
	#include <fog_vertex>
}`,Cb=`uniform vec3 diffuse;
uniform float opacity;
#include <common>
#include <color_pars_fragment>
#include <map_particle_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <fog_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	vec3 outgoingLight = vec3( 0.0 );
	#include <logdepthbuf_fragment>
	#include <map_particle_fragment>
	#include <color_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	outgoingLight = diffuseColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
}`,Rb=`#include <common>
#include <batching_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <shadowmap_pars_vertex>
void main() {
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphinstance_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <worldpos_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,Pb=`uniform vec3 color;
uniform float opacity;
#include <common>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <logdepthbuf_pars_fragment>
#include <shadowmap_pars_fragment>
#include <shadowmask_pars_fragment>
void main() {
	#include <logdepthbuf_fragment>
	gl_FragColor = vec4( color, opacity * ( 1.0 - getShadowMask() ) );
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
}`,Ib=`uniform float rotation;
uniform vec2 center;
#include <common>
#include <uv_pars_vertex>
#include <fog_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	vec4 mvPosition = modelViewMatrix[ 3 ];
	vec2 scale = vec2( length( modelMatrix[ 0 ].xyz ), length( modelMatrix[ 1 ].xyz ) );
	#ifndef USE_SIZEATTENUATION
		bool isPerspective = isPerspectiveMatrix( projectionMatrix );
		if ( isPerspective ) scale *= - mvPosition.z;
	#endif
	vec2 alignedPosition = ( position.xy - ( center - vec2( 0.5 ) ) ) * scale;
	vec2 rotatedPosition;
	rotatedPosition.x = cos( rotation ) * alignedPosition.x - sin( rotation ) * alignedPosition.y;
	rotatedPosition.y = sin( rotation ) * alignedPosition.x + cos( rotation ) * alignedPosition.y;
	mvPosition.xy += rotatedPosition;
	gl_Position = projectionMatrix * mvPosition;
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <fog_vertex>
}`,Lb=`uniform vec3 diffuse;
uniform float opacity;
#include <common>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <fog_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	vec3 outgoingLight = vec3( 0.0 );
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	outgoingLight = diffuseColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
}`,me={alphahash_fragment:tS,alphahash_pars_fragment:eS,alphamap_fragment:nS,alphamap_pars_fragment:iS,alphatest_fragment:sS,alphatest_pars_fragment:rS,aomap_fragment:oS,aomap_pars_fragment:aS,batching_pars_vertex:lS,batching_vertex:cS,begin_vertex:hS,beginnormal_vertex:uS,bsdfs:fS,iridescence_fragment:dS,bumpmap_pars_fragment:pS,clipping_planes_fragment:mS,clipping_planes_pars_fragment:gS,clipping_planes_pars_vertex:_S,clipping_planes_vertex:xS,color_fragment:yS,color_pars_fragment:vS,color_pars_vertex:SS,color_vertex:MS,common:bS,defaultnormal_vertex:wS,displacementmap_pars_vertex:TS,displacementmap_vertex:ES,emissivemap_fragment:AS,emissivemap_pars_fragment:CS,colorspace_fragment:RS,colorspace_pars_fragment:PS,envmap_fragment:IS,envmap_common_pars_fragment:LS,envmap_pars_fragment:DS,envmap_pars_vertex:NS,envmap_physical_pars_fragment:XS,envmap_vertex:US,fog_vertex:FS,fog_pars_vertex:OS,fog_fragment:BS,fog_pars_fragment:kS,gradientmap_pars_fragment:zS,lightmap_pars_fragment:VS,lights_lambert_fragment:GS,lights_lambert_pars_fragment:HS,lights_pars_begin:WS,lights_toon_fragment:qS,lights_toon_pars_fragment:$S,lights_phong_fragment:YS,lights_phong_pars_fragment:ZS,lights_physical_fragment:JS,lights_physical_pars_fragment:KS,lights_fragment_begin:jS,lights_fragment_maps:QS,lights_fragment_end:tM,lightprobes_pars_fragment:eM,logdepthbuf_fragment:nM,logdepthbuf_pars_fragment:iM,logdepthbuf_pars_vertex:sM,logdepthbuf_vertex:rM,map_fragment:oM,map_pars_fragment:aM,map_particle_fragment:lM,map_particle_pars_fragment:cM,metalnessmap_fragment:hM,metalnessmap_pars_fragment:uM,morphinstance_vertex:fM,morphcolor_vertex:dM,morphnormal_vertex:pM,morphtarget_pars_vertex:mM,morphtarget_vertex:gM,normal_fragment_begin:_M,normal_fragment_maps:xM,normal_pars_fragment:yM,normal_pars_vertex:vM,normal_vertex:SM,normalmap_pars_fragment:MM,clearcoat_normal_fragment_begin:bM,clearcoat_normal_fragment_maps:wM,clearcoat_pars_fragment:TM,iridescence_pars_fragment:EM,opaque_fragment:AM,packing:CM,premultiplied_alpha_fragment:RM,project_vertex:PM,dithering_fragment:IM,dithering_pars_fragment:LM,roughnessmap_fragment:DM,roughnessmap_pars_fragment:NM,shadowmap_pars_fragment:UM,shadowmap_pars_vertex:FM,shadowmap_vertex:OM,shadowmask_pars_fragment:BM,skinbase_vertex:kM,skinning_pars_vertex:zM,skinning_vertex:VM,skinnormal_vertex:GM,specularmap_fragment:HM,specularmap_pars_fragment:WM,tonemapping_fragment:XM,tonemapping_pars_fragment:qM,transmission_fragment:$M,transmission_pars_fragment:YM,uv_pars_fragment:ZM,uv_pars_vertex:JM,uv_vertex:KM,worldpos_vertex:jM,background_vert:QM,background_frag:tb,backgroundCube_vert:eb,backgroundCube_frag:nb,cube_vert:ib,cube_frag:sb,depth_vert:rb,depth_frag:ob,distance_vert:ab,distance_frag:lb,equirect_vert:cb,equirect_frag:hb,linedashed_vert:ub,linedashed_frag:fb,meshbasic_vert:db,meshbasic_frag:pb,meshlambert_vert:mb,meshlambert_frag:gb,meshmatcap_vert:_b,meshmatcap_frag:xb,meshnormal_vert:yb,meshnormal_frag:vb,meshphong_vert:Sb,meshphong_frag:Mb,meshphysical_vert:bb,meshphysical_frag:wb,meshtoon_vert:Tb,meshtoon_frag:Eb,points_vert:Ab,points_frag:Cb,shadow_vert:Rb,shadow_frag:Pb,sprite_vert:Ib,sprite_frag:Lb},Ut={common:{diffuse:{value:new ue(16777215)},opacity:{value:1},map:{value:null},mapTransform:{value:new oe},alphaMap:{value:null},alphaMapTransform:{value:new oe},alphaTest:{value:0}},specularmap:{specularMap:{value:null},specularMapTransform:{value:new oe}},envmap:{envMap:{value:null},envMapRotation:{value:new oe},reflectivity:{value:1},ior:{value:1.5},refractionRatio:{value:.98},dfgLUT:{value:null}},aomap:{aoMap:{value:null},aoMapIntensity:{value:1},aoMapTransform:{value:new oe}},lightmap:{lightMap:{value:null},lightMapIntensity:{value:1},lightMapTransform:{value:new oe}},bumpmap:{bumpMap:{value:null},bumpMapTransform:{value:new oe},bumpScale:{value:1}},normalmap:{normalMap:{value:null},normalMapTransform:{value:new oe},normalScale:{value:new Jt(1,1)}},displacementmap:{displacementMap:{value:null},displacementMapTransform:{value:new oe},displacementScale:{value:1},displacementBias:{value:0}},emissivemap:{emissiveMap:{value:null},emissiveMapTransform:{value:new oe}},metalnessmap:{metalnessMap:{value:null},metalnessMapTransform:{value:new oe}},roughnessmap:{roughnessMap:{value:null},roughnessMapTransform:{value:new oe}},gradientmap:{gradientMap:{value:null}},fog:{fogDensity:{value:25e-5},fogNear:{value:1},fogFar:{value:2e3},fogColor:{value:new ue(16777215)}},lights:{ambientLightColor:{value:[]},lightProbe:{value:[]},sunLights:{value:[],properties:{direction:{},color:{}}},sunLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},sunShadowMatrix:{value:[]},sunShadowCascade:{value:[]},directionalLights:{value:[],properties:{direction:{},color:{}}},directionalLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},directionalShadowMatrix:{value:[]},spotLights:{value:[],properties:{color:{},position:{},direction:{},distance:{},coneCos:{},penumbraCos:{},decay:{}}},spotLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},spotLightMap:{value:[]},spotLightMatrix:{value:[]},pointLights:{value:[],properties:{color:{},position:{},decay:{},distance:{}}},pointLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{},shadowCameraNear:{},shadowCameraFar:{}}},pointShadowMatrix:{value:[]},hemisphereLights:{value:[],properties:{direction:{},skyColor:{},groundColor:{}}},rectAreaLights:{value:[],properties:{color:{},position:{},width:{},height:{}}},ltc_1:{value:null},ltc_2:{value:null},probesSH:{value:[]},probesMin:{value:[]},probesMax:{value:[]},probesResolution:{value:[]}},points:{diffuse:{value:new ue(16777215)},opacity:{value:1},size:{value:1},scale:{value:1},map:{value:null},alphaMap:{value:null},alphaMapTransform:{value:new oe},alphaTest:{value:0},uvTransform:{value:new oe}},sprite:{diffuse:{value:new ue(16777215)},opacity:{value:1},center:{value:new Jt(.5,.5)},rotation:{value:0},map:{value:null},mapTransform:{value:new oe},alphaMap:{value:null},alphaMapTransform:{value:new oe},alphaTest:{value:0}}},cs={basic:{uniforms:Hn([Ut.common,Ut.specularmap,Ut.envmap,Ut.aomap,Ut.lightmap,Ut.fog]),vertexShader:me.meshbasic_vert,fragmentShader:me.meshbasic_frag},lambert:{uniforms:Hn([Ut.common,Ut.specularmap,Ut.envmap,Ut.aomap,Ut.lightmap,Ut.emissivemap,Ut.bumpmap,Ut.normalmap,Ut.displacementmap,Ut.fog,Ut.lights,{emissive:{value:new ue(0)},envMapIntensity:{value:1}}]),vertexShader:me.meshlambert_vert,fragmentShader:me.meshlambert_frag},phong:{uniforms:Hn([Ut.common,Ut.specularmap,Ut.envmap,Ut.aomap,Ut.lightmap,Ut.emissivemap,Ut.bumpmap,Ut.normalmap,Ut.displacementmap,Ut.fog,Ut.lights,{emissive:{value:new ue(0)},specular:{value:new ue(1118481)},shininess:{value:30},envMapIntensity:{value:1}}]),vertexShader:me.meshphong_vert,fragmentShader:me.meshphong_frag},standard:{uniforms:Hn([Ut.common,Ut.envmap,Ut.aomap,Ut.lightmap,Ut.emissivemap,Ut.bumpmap,Ut.normalmap,Ut.displacementmap,Ut.roughnessmap,Ut.metalnessmap,Ut.fog,Ut.lights,{emissive:{value:new ue(0)},roughness:{value:1},metalness:{value:0},envMapIntensity:{value:1}}]),vertexShader:me.meshphysical_vert,fragmentShader:me.meshphysical_frag},toon:{uniforms:Hn([Ut.common,Ut.aomap,Ut.lightmap,Ut.emissivemap,Ut.bumpmap,Ut.normalmap,Ut.displacementmap,Ut.gradientmap,Ut.fog,Ut.lights,{emissive:{value:new ue(0)}}]),vertexShader:me.meshtoon_vert,fragmentShader:me.meshtoon_frag},matcap:{uniforms:Hn([Ut.common,Ut.bumpmap,Ut.normalmap,Ut.displacementmap,Ut.fog,{matcap:{value:null}}]),vertexShader:me.meshmatcap_vert,fragmentShader:me.meshmatcap_frag},points:{uniforms:Hn([Ut.points,Ut.fog]),vertexShader:me.points_vert,fragmentShader:me.points_frag},dashed:{uniforms:Hn([Ut.common,Ut.fog,{scale:{value:1},dashSize:{value:1},totalSize:{value:2}}]),vertexShader:me.linedashed_vert,fragmentShader:me.linedashed_frag},depth:{uniforms:Hn([Ut.common,Ut.displacementmap]),vertexShader:me.depth_vert,fragmentShader:me.depth_frag},normal:{uniforms:Hn([Ut.common,Ut.bumpmap,Ut.normalmap,Ut.displacementmap,{opacity:{value:1}}]),vertexShader:me.meshnormal_vert,fragmentShader:me.meshnormal_frag},sprite:{uniforms:Hn([Ut.sprite,Ut.fog]),vertexShader:me.sprite_vert,fragmentShader:me.sprite_frag},background:{uniforms:{uvTransform:{value:new oe},t2D:{value:null},backgroundIntensity:{value:1}},vertexShader:me.background_vert,fragmentShader:me.background_frag},backgroundCube:{uniforms:{envMap:{value:null},backgroundBlurriness:{value:0},backgroundIntensity:{value:1},backgroundRotation:{value:new oe}},vertexShader:me.backgroundCube_vert,fragmentShader:me.backgroundCube_frag},cube:{uniforms:{tCube:{value:null},tFlip:{value:-1},opacity:{value:1}},vertexShader:me.cube_vert,fragmentShader:me.cube_frag},equirect:{uniforms:{tEquirect:{value:null}},vertexShader:me.equirect_vert,fragmentShader:me.equirect_frag},distance:{uniforms:Hn([Ut.common,Ut.displacementmap,{referencePosition:{value:new X},nearDistance:{value:1},farDistance:{value:1e3}}]),vertexShader:me.distance_vert,fragmentShader:me.distance_frag},shadow:{uniforms:Hn([Ut.lights,Ut.fog,{color:{value:new ue(0)},opacity:{value:1}}]),vertexShader:me.shadow_vert,fragmentShader:me.shadow_frag}};cs.physical={uniforms:Hn([cs.standard.uniforms,{clearcoat:{value:0},clearcoatMap:{value:null},clearcoatMapTransform:{value:new oe},clearcoatNormalMap:{value:null},clearcoatNormalMapTransform:{value:new oe},clearcoatNormalScale:{value:new Jt(1,1)},clearcoatRoughness:{value:0},clearcoatRoughnessMap:{value:null},clearcoatRoughnessMapTransform:{value:new oe},diffuseRoughness:{value:0},diffuseRoughnessMap:{value:null},diffuseRoughnessMapTransform:{value:new oe},dispersion:{value:0},retroreflectivity:{value:0},iridescence:{value:0},iridescenceMap:{value:null},iridescenceMapTransform:{value:new oe},iridescenceIOR:{value:1.3},iridescenceThicknessMinimum:{value:100},iridescenceThicknessMaximum:{value:400},iridescenceThicknessMap:{value:null},iridescenceThicknessMapTransform:{value:new oe},sheen:{value:0},sheenColor:{value:new ue(0)},sheenColorMap:{value:null},sheenColorMapTransform:{value:new oe},sheenRoughness:{value:1},sheenRoughnessMap:{value:null},sheenRoughnessMapTransform:{value:new oe},transmission:{value:0},transmissionMap:{value:null},transmissionMapTransform:{value:new oe},transmissionSamplerSize:{value:new Jt},transmissionSamplerMap:{value:null},thickness:{value:0},thicknessMap:{value:null},thicknessMapTransform:{value:new oe},attenuationDistance:{value:0},attenuationColor:{value:new ue(0)},specularColor:{value:new ue(1,1,1)},specularColorMap:{value:null},specularColorMapTransform:{value:new oe},specularIntensity:{value:1},specularIntensityMap:{value:null},specularIntensityMapTransform:{value:new oe},anisotropyVector:{value:new Jt},anisotropyMap:{value:null},anisotropyMapTransform:{value:new oe}}]),vertexShader:me.meshphysical_vert,fragmentShader:me.meshphysical_frag};var Lh={r:0,b:0,g:0},Db=new De,Kg=new oe;Kg.set(-1,0,0,0,1,0,0,0,1);function Nb(i,t,e,n,s,r){let o=new ue(0),a=s===!0?0:1,l,c,f=null,u=0,h=null;function d(v){let A=v.isScene===!0?v.background:null;if(A&&A.isTexture){let S=v.backgroundBlurriness>0;A=t.get(A,S)}return A}function p(v){let A=!1,S=d(v);S===null?g(o,a):S&&S.isColor&&(g(S,1),A=!0);let R=i.xr.getEnvironmentBlendMode();R==="additive"?e.buffers.color.setClear(0,0,0,1,r):R==="alpha-blend"&&e.buffers.color.setClear(0,0,0,0,r),(i.autoClear||A)&&(e.buffers.depth.setTest(!0),e.buffers.depth.setMask(!0),e.buffers.color.setMask(!0),i.clear(i.autoClearColor,i.autoClearDepth,i.autoClearStencil))}function _(v,A){let S=d(A);S&&S.isCubeTexture?(c===void 0&&(c=new bn(new _i(1,1,1),new rs({name:"BackgroundCubeMaterial",uniforms:Mr(cs.backgroundCube.uniforms),vertexShader:cs.backgroundCube.vertexShader,fragmentShader:cs.backgroundCube.fragmentShader,side:ei,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),c.geometry.deleteAttribute("normal"),c.geometry.deleteAttribute("uv"),c.onBeforeRender=function(R,E,x){this.matrixWorld.copyPosition(x.matrixWorld)},Object.defineProperty(c.material,"envMap",{get:function(){return this.uniforms.envMap.value}}),n.update(c)),c.material.uniforms.envMap.value=S,c.material.uniforms.backgroundBlurriness.value=A.backgroundBlurriness,c.material.uniforms.backgroundIntensity.value=A.backgroundIntensity,c.material.uniforms.backgroundRotation.value.setFromMatrix4(Db.makeRotationFromEuler(A.backgroundRotation)).transpose(),S.isRenderTargetTexture===!1&&c.material.uniforms.backgroundRotation.value.premultiply(Kg),c.material.toneMapped=Me.getTransfer(S.colorSpace)!==Le,(f!==S||u!==S.version||h!==i.toneMapping)&&(c.material.needsUpdate=!0,f=S,u=S.version,h=i.toneMapping),c.layers.enableAll(),v.unshift(c,c.geometry,c.material,0,0,null)):S&&S.isTexture&&(l===void 0&&(l=new bn(new Ea(2,2),new rs({name:"BackgroundMaterial",uniforms:Mr(cs.background.uniforms),vertexShader:cs.background.vertexShader,fragmentShader:cs.background.fragmentShader,side:js,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),l.geometry.deleteAttribute("normal"),Object.defineProperty(l.material,"map",{get:function(){return this.uniforms.t2D.value}}),n.update(l)),l.material.uniforms.t2D.value=S,l.material.uniforms.backgroundIntensity.value=A.backgroundIntensity,l.material.toneMapped=Me.getTransfer(S.colorSpace)!==Le,S.matrixAutoUpdate===!0&&S.updateMatrix(),l.material.uniforms.uvTransform.value.copy(S.matrix),(f!==S||u!==S.version||h!==i.toneMapping)&&(l.material.needsUpdate=!0,f=S,u=S.version,h=i.toneMapping),l.layers.enableAll(),v.unshift(l,l.geometry,l.material,0,0,null))}function g(v,A){v.getRGB(Lh,kf(i)),e.buffers.color.setClear(Lh.r,Lh.g,Lh.b,A,r)}function m(){c!==void 0&&(c.geometry.dispose(),c.material.dispose(),c=void 0),l!==void 0&&(l.geometry.dispose(),l.material.dispose(),l=void 0)}return{getClearColor:function(){return o},setClearColor:function(v,A=1){o.set(v),a=A,g(o,a)},getClearAlpha:function(){return a},setClearAlpha:function(v){a=v,g(o,a)},render:p,addToRenderList:_,dispose:m}}function Ub(i,t){let e=i.getParameter(i.MAX_VERTEX_ATTRIBS),n={},s=h(null),r=s,o=!1;function a(L,z,O,P,G){let q=!1,H=u(L,P,O,z);r!==H&&(r=H,c(r.object)),q=d(L,P,O,G),q&&p(L,P,O,G),G!==null&&t.update(G,i.ELEMENT_ARRAY_BUFFER),(q||o)&&(o=!1,S(L,z,O,P),G!==null&&i.bindBuffer(i.ELEMENT_ARRAY_BUFFER,t.get(G).buffer))}function l(){return i.createVertexArray()}function c(L){return i.bindVertexArray(L)}function f(L){return i.deleteVertexArray(L)}function u(L,z,O,P){let G=P.wireframe===!0,q=n[z.id];q===void 0&&(q={},n[z.id]=q);let H=L.isInstancedMesh===!0?L.id:0,ct=q[H];ct===void 0&&(ct={},q[H]=ct);let K=ct[O.id];K===void 0&&(K={},ct[O.id]=K);let et=K[G];return et===void 0&&(et=h(l()),K[G]=et),et}function h(L){let z=[],O=[],P=[];for(let G=0;G<e;G++)z[G]=0,O[G]=0,P[G]=0;return{geometry:null,program:null,wireframe:!1,newAttributes:z,enabledAttributes:O,attributeDivisors:P,object:L,attributes:{},index:null}}function d(L,z,O,P){let G=r.attributes,q=z.attributes,H=0,ct=O.getAttributes();for(let K in ct)if(ct[K].location>=0){let st=G[K],pt=q[K];if(pt===void 0&&(K==="instanceMatrix"&&L.instanceMatrix&&(pt=L.instanceMatrix),K==="instanceColor"&&L.instanceColor&&(pt=L.instanceColor)),st===void 0||st.attribute!==pt||pt&&st.data!==pt.data)return!0;H++}return r.attributesNum!==H||r.index!==P}function p(L,z,O,P){let G={},q=z.attributes,H=0,ct=O.getAttributes();for(let K in ct)if(ct[K].location>=0){let st=q[K];st===void 0&&(K==="instanceMatrix"&&L.instanceMatrix&&(st=L.instanceMatrix),K==="instanceColor"&&L.instanceColor&&(st=L.instanceColor));let pt={};pt.attribute=st,st&&st.data&&(pt.data=st.data),G[K]=pt,H++}r.attributes=G,r.attributesNum=H,r.index=P}function _(){let L=r.newAttributes;for(let z=0,O=L.length;z<O;z++)L[z]=0}function g(L){m(L,0)}function m(L,z){let O=r.newAttributes,P=r.enabledAttributes,G=r.attributeDivisors;O[L]=1,P[L]===0&&(i.enableVertexAttribArray(L),P[L]=1),G[L]!==z&&(i.vertexAttribDivisor(L,z),G[L]=z)}function v(){let L=r.newAttributes,z=r.enabledAttributes;for(let O=0,P=z.length;O<P;O++)z[O]!==L[O]&&(i.disableVertexAttribArray(O),z[O]=0)}function A(L,z,O,P,G,q,H){H===!0?i.vertexAttribIPointer(L,z,O,G,q):i.vertexAttribPointer(L,z,O,P,G,q)}function S(L,z,O,P){_();let G=P.attributes,q=O.getAttributes(),H=z.defaultAttributeValues;for(let ct in q){let K=q[ct];if(K.location>=0){let et=G[ct];if(et===void 0&&(ct==="instanceMatrix"&&L.instanceMatrix&&(et=L.instanceMatrix),ct==="instanceColor"&&L.instanceColor&&(et=L.instanceColor)),et!==void 0){let st=et.normalized,pt=et.itemSize,dt=t.get(et);if(dt===void 0)continue;let Q=dt.buffer,_t=dt.type,vt=dt.bytesPerElement,Pt=_t===i.INT||_t===i.UNSIGNED_INT||et.gpuType===Yc;if(et.isInterleavedBufferAttribute){let Tt=et.data,Yt=Tt.isInterleavedBuffer===!0?Tt.stride:Tt.itemSize,ce=et.offset;if(Tt.isInstancedInterleavedBuffer||Tt.isInstancedBufferAttribute){for(let Xt=0;Xt<K.locationSize;Xt++)m(K.location+Xt,Tt.meshPerAttribute);L.isInstancedMesh!==!0&&P._maxInstanceCount===void 0&&(P._maxInstanceCount=Tt.meshPerAttribute*Tt.count)}else for(let Xt=0;Xt<K.locationSize;Xt++)g(K.location+Xt);i.bindBuffer(i.ARRAY_BUFFER,Q);for(let Xt=0;Xt<K.locationSize;Xt++)A(K.location+Xt,pt/K.locationSize,_t,st,Yt*vt,(ce+pt/K.locationSize*Xt)*vt,Pt)}else{if(et.isInstancedBufferAttribute){for(let Tt=0;Tt<K.locationSize;Tt++)m(K.location+Tt,et.meshPerAttribute);L.isInstancedMesh!==!0&&P._maxInstanceCount===void 0&&(P._maxInstanceCount=et.meshPerAttribute*et.count)}else for(let Tt=0;Tt<K.locationSize;Tt++)g(K.location+Tt);i.bindBuffer(i.ARRAY_BUFFER,Q);for(let Tt=0;Tt<K.locationSize;Tt++)A(K.location+Tt,pt/K.locationSize,_t,st,pt*vt,pt/K.locationSize*Tt*vt,Pt)}}else if(H!==void 0){let st=H[ct];if(st!==void 0)switch(st.length){case 2:i.vertexAttrib2fv(K.location,st);break;case 3:i.vertexAttrib3fv(K.location,st);break;case 4:i.vertexAttrib4fv(K.location,st);break;default:i.vertexAttrib1fv(K.location,st)}}}}v()}function R(){U();for(let L in n){let z=n[L];for(let O in z){let P=z[O];for(let G in P){let q=P[G];for(let H in q)f(q[H].object),delete q[H];delete P[G]}}delete n[L]}}function E(L){if(n[L.id]===void 0)return;let z=n[L.id];for(let O in z){let P=z[O];for(let G in P){let q=P[G];for(let H in q)f(q[H].object),delete q[H];delete P[G]}}delete n[L.id]}function x(L){for(let z in n){let O=n[z];for(let P in O){let G=O[P];if(G[L.id]===void 0)continue;let q=G[L.id];for(let H in q)f(q[H].object),delete q[H];delete G[L.id]}}}function T(L){for(let z in n){let O=n[z],P=L.isInstancedMesh===!0?L.id:0,G=O[P];if(G!==void 0){for(let q in G){let H=G[q];for(let ct in H)f(H[ct].object),delete H[ct];delete G[q]}delete O[P],Object.keys(O).length===0&&delete n[z]}}}function U(){N(),o=!0,r!==s&&(r=s,c(r.object))}function N(){s.geometry=null,s.program=null,s.wireframe=!1}return{setup:a,reset:U,resetDefaultState:N,dispose:R,releaseStatesOfGeometry:E,releaseStatesOfObject:T,releaseStatesOfProgram:x,initAttributes:_,enableAttribute:g,disableUnusedAttributes:v}}function Fb(i,t,e){let n;function s(l){n=l}function r(l,c){i.drawArrays(n,l,c),e.update(c,n,1)}function o(l,c,f){f!==0&&(i.drawArraysInstanced(n,l,c,f),e.update(c,n,f))}function a(l,c,f){if(f===0)return;t.get("WEBGL_multi_draw").multiDrawArraysWEBGL(n,l,0,c,0,f);let h=0;for(let d=0;d<f;d++)h+=c[d];e.update(h,n,1)}this.setMode=s,this.render=r,this.renderInstances=o,this.renderMultiDraw=a}function Ob(i,t,e,n){let s;function r(){if(s!==void 0)return s;if(t.has("EXT_texture_filter_anisotropic")===!0){let x=t.get("EXT_texture_filter_anisotropic");s=i.getParameter(x.MAX_TEXTURE_MAX_ANISOTROPY_EXT)}else s=0;return s}function o(x){return!(x!==Vi&&n.convert(x)!==i.getParameter(i.IMPLEMENTATION_COLOR_READ_FORMAT))}function a(x){let T=x===zi&&(t.has("EXT_color_buffer_half_float")||t.has("EXT_color_buffer_float"));return!(x!==ai&&x!==ki&&!T&&n.convert(x)!==i.getParameter(i.IMPLEMENTATION_COLOR_READ_TYPE))}function l(x){if(x==="highp"){if(i.getShaderPrecisionFormat(i.VERTEX_SHADER,i.HIGH_FLOAT).precision>0&&i.getShaderPrecisionFormat(i.FRAGMENT_SHADER,i.HIGH_FLOAT).precision>0)return"highp";x="mediump"}return x==="mediump"&&i.getShaderPrecisionFormat(i.VERTEX_SHADER,i.MEDIUM_FLOAT).precision>0&&i.getShaderPrecisionFormat(i.FRAGMENT_SHADER,i.MEDIUM_FLOAT).precision>0?"mediump":"lowp"}let c=e.precision!==void 0?e.precision:"highp",f=l(c);f!==c&&(jt("WebGLRenderer:",c,"not supported, using",f,"instead."),c=f);let u=e.reversedDepthBuffer===!0&&t.has("EXT_clip_control"),h=e.logarithmicDepthBuffer===!0&&u===!1;e.reversedDepthBuffer===!0&&u===!1&&jt("WebGLRenderer: Unable to use reversed depth buffer due to missing EXT_clip_control extension. Fallback to default depth buffer."),e.logarithmicDepthBuffer===!0&&u===!0&&jt("WebGLRenderer: Logarithmic depth buffer is ignored when reversed depth buffer is enabled.");let d=i.getParameter(i.MAX_TEXTURE_IMAGE_UNITS),p=i.getParameter(i.MAX_VERTEX_TEXTURE_IMAGE_UNITS),_=i.getParameter(i.MAX_TEXTURE_SIZE),g=i.getParameter(i.MAX_CUBE_MAP_TEXTURE_SIZE),m=i.getParameter(i.MAX_VERTEX_ATTRIBS),v=i.getParameter(i.MAX_VERTEX_UNIFORM_VECTORS),A=i.getParameter(i.MAX_VARYING_VECTORS),S=i.getParameter(i.MAX_FRAGMENT_UNIFORM_VECTORS),R=i.getParameter(i.MAX_SAMPLES),E=i.getParameter(i.SAMPLES);return{isWebGL2:!0,getMaxAnisotropy:r,getMaxPrecision:l,textureFormatReadable:o,textureTypeReadable:a,precision:c,logarithmicDepthBuffer:h,reversedDepthBuffer:u,maxTextures:d,maxVertexTextures:p,maxTextureSize:_,maxCubemapSize:g,maxAttributes:m,maxVertexUniforms:v,maxVaryings:A,maxFragmentUniforms:S,maxSamples:R,samples:E}}function Bb(i){let t=this,e=null,n=0,s=!1,r=!1,o=new mi,a=new oe,l={value:null,needsUpdate:!1};this.uniform=l,this.numPlanes=0,this.numIntersection=0,this.init=function(u,h){let d=u.length!==0||h||n!==0||s;return s=h,n=u.length,d},this.beginShadows=function(){r=!0,f(null)},this.endShadows=function(){r=!1},this.setGlobalState=function(u,h){e=f(u,h,0)},this.setState=function(u,h,d){let p=u.clippingPlanes,_=u.clipIntersection,g=u.clipShadows,m=i.get(u);if(!s||p===null||p.length===0||r&&!g)r?f(null):c();else{let v=r?0:n,A=v*4,S=m.clippingState||null;l.value=S,S=f(p,h,A,d);for(let R=0;R!==A;++R)S[R]=e[R];m.clippingState=S,this.numIntersection=_?this.numPlanes:0,this.numPlanes+=v}};function c(){l.value!==e&&(l.value=e,l.needsUpdate=n>0),t.numPlanes=n,t.numIntersection=0}function f(u,h,d,p){let _=u!==null?u.length:0,g=null;if(_!==0){if(g=l.value,p!==!0||g===null){let m=d+_*4,v=h.matrixWorldInverse;a.getNormalMatrix(v),(g===null||g.length<m)&&(g=new Float32Array(m));for(let A=0,S=d;A!==_;++A,S+=4)o.copy(u[A]).applyMatrix4(v,a),o.normal.toArray(g,S),g[S+3]=o.constant}l.value=g,l.needsUpdate=!0}return t.numPlanes=_,t.numIntersection=0,g}}var $a=class extends gi{constructor(t=1,e={}){super(t,t,e),this.isWebGLCubeRenderTarget=!0;let n={width:t,height:t,depth:1},s=[n,n,n,n,n,n];this.texture=new Sa(s),this._setTextureOptions(e),this.texture.isRenderTargetTexture=!0}fromEquirectangularTexture(t,e){this.texture.type=e.type,this.texture.colorSpace=e.colorSpace,this.texture.generateMipmaps=e.generateMipmaps,this.texture.minFilter=e.minFilter,this.texture.magFilter=e.magFilter;let n={uniforms:{tEquirect:{value:null}},vertexShader:`

				varying vec3 vWorldDirection;

				vec3 transformDirection( in vec3 dir, in mat4 matrix ) {

					return normalize( ( matrix * vec4( dir, 0.0 ) ).xyz );

				}

				void main() {

					vWorldDirection = transformDirection( position, modelMatrix );

					#include <begin_vertex>
					#include <project_vertex>

				}
			`,fragmentShader:`

				uniform sampler2D tEquirect;

				varying vec3 vWorldDirection;

				#include <common>

				void main() {

					vec3 direction = normalize( vWorldDirection );

					vec2 sampleUV = equirectUv( direction );

					gl_FragColor = texture2D( tEquirect, sampleUV );

				}
			`},s=new _i(5,5,5),r=new rs({name:"CubemapFromEquirect",uniforms:Mr(n.uniforms),vertexShader:n.vertexShader,fragmentShader:n.fragmentShader,side:ei,blending:xr});r.uniforms.tEquirect.value=e;let o=new bn(s,r),a=e.minFilter;return e.minFilter===Es&&(e.minFilter=jn),new So(1,10,this).update(t,o),e.minFilter=a,o.geometry.dispose(),o.material.dispose(),this}clear(t,e=!0,n=!0,s=!0){let r=t.getRenderTarget();for(let o=0;o<6;o++)t.setRenderTarget(this,o),t.clear(e,n,s);t.setRenderTarget(r)}},Rg=256,kb=3,zb=20,jg=256,Qg=16,Vb=3,Gb=new X,Hb=new ue,Nh=class i{constructor(t){this._renderer=t,this._cubeSize=0,this._sourceTarget=null,this._cubeCamera=new So(1,10,null),this._boxMesh=new bn(new _i(5,5,5),null),this._cubemapMaterial=null,this._equirectMaterial=null,this._blurMaterial=null,this._ggxMaterial=null,this._integrationMaterial=null}fromScene(t,e=0,n=.1,s=100,r={}){let{size:o=256,position:a=Gb}=r,l=this._renderer;this._setSize(o);let c=this._allocateTarget(),f=this._getSourceTarget(!0);e>0&&(f.texture.mipmapsAutoUpdate=!1);let u=l.autoClear,h=l.autoClearColor,d=l.autoClearDepth,p=l.autoClearStencil,_=t.background;l.autoClear=!0,l.autoClearColor=!0,l.autoClearDepth=!0,l.autoClearStencil=!0,_===null&&(t.background=l.getClearColor(Hb));let g=new So(n,s,f);return g.position.copy(a),g.update(l,t),l.autoClear=u,l.autoClearColor=h,l.autoClearDepth=d,l.autoClearStencil=p,t.background=_,e>0&&(f.texture.mipmapsAutoUpdate=!0,this._blur(c,e)),this._applyPMREM(c),c}fromEquirectangular(t,e=null){return this._fromTexture(t,e)}fromCubemap(t,e=null){return this._fromTexture(t,e)}compileCubemapShader(){this._cubemapMaterial===null&&(this._cubemapMaterial=Lg(),this._compileMaterial(this._cubemapMaterial))}compileEquirectangularShader(){this._equirectMaterial===null&&(this._equirectMaterial=Ig(),this._compileMaterial(this._equirectMaterial))}dispose(){this._sourceTarget!==null&&this._sourceTarget.dispose(),this._cubemapMaterial!==null&&this._cubemapMaterial.dispose(),this._equirectMaterial!==null&&this._equirectMaterial.dispose(),this._blurMaterial!==null&&this._blurMaterial.dispose(),this._ggxMaterial!==null&&this._ggxMaterial.dispose(),this._integrationMaterial!==null&&this._integrationMaterial.dispose(),this._boxMesh.geometry.dispose()}static lodToRoughness(t,e){return e>0?1-Math.sqrt(1-t/e):0}_setSize(t){this._cubeSize=Math.max(Rg,Uf(t))}_fromTexture(t,e){t.mapping===vr||t.mapping===To?this._setSize(t.image.length===0?Rg:t.image[0].width||t.image[0].image.width):this._setSize(t.image.width/4);let n=e||this._allocateTarget();return this._textureToCubemap(t),this._applyPMREM(n),n}_allocateTarget(){let t=this._cubeSize,e=Pg(t,!1,!1),n=Math.log2(t)-kb;for(let s=0;s<=n;s++)e.texture.mipmaps.push({width:t>>s,height:t>>s});return e.texture.name="PMREM",e.texture.isPMREMTexture=!0,e}_getSourceTarget(t=!1){let e=this._cubeSize,n=this._sourceTarget;return(n===null||n.width!==e||t&&n.depthBuffer===!1)&&(n!==null&&n.dispose(),this._sourceTarget=Pg(e,!0,t)),this._sourceTarget}_compileMaterial(t){this._boxMesh.material=t,this._renderer.compile(this._boxMesh,this._cubeCamera.children[0])}_renderCube(t,e,n){let s=this._boxMesh,r=this._cubeCamera;s.material=n,r.renderTarget=t,r.activeMipmapLevel=e;let o=t.width>>e;t.viewport.set(0,0,o,o),r.update(this._renderer,s),t.viewport.set(0,0,t.width,t.height)}_textureToCubemap(t){let e;t.mapping===vr||t.mapping===To?(this._cubemapMaterial===null&&(this._cubemapMaterial=Lg()),e=this._cubemapMaterial,e.uniforms.flipEnvMap.value=t.isRenderTargetTexture===!1?-1:1):(this._equirectMaterial===null&&(this._equirectMaterial=Ig()),e=this._equirectMaterial),e.uniforms.envMap.value=t,this._renderCube(this._getSourceTarget(),0,e)}_applyPMREM(t){this._ggxMaterial===null&&(this._ggxMaterial=Wb(),this._integrationMaterial=Xb());let e=this._cubeSize,n=t.texture.mipmaps.length-1,s=this._ggxMaterial.uniforms;s.envMap.value=this._sourceTarget.texture;let r=this._integrationMaterial.uniforms;r.envMap.value=this._sourceTarget.texture,r.sourceLod.value=Math.log2(e/Qg);for(let o=0;o<=n;o++){let a=i.lodToRoughness(o,n);if(o>n-Vb)r.roughness.value=a,this._renderCube(t,o,this._integrationMaterial);else{let l=a>0?Math.log2(e)+.5*Math.log2(6/(jg*Math.pow(a,4)))+.5:0;s.roughness.value=a,s.lodBias.value=l,this._renderCube(t,o,this._ggxMaterial)}}}_blur(t,e){this._blurMaterial===null&&(this._blurMaterial=qb());let n=this._blurMaterial,s=n.uniforms,r=this._sourceTarget;s.sigma.value=Math.min(e,Math.PI)/Math.SQRT2,s.envMap.value=r.texture,this._renderCube(t,0,n),s.envMap.value=t.texture,this._renderCube(r,0,n)}};function Pg(i,t,e){return new $a(i,{minFilter:Es,generateMipmaps:t,type:zi,colorSpace:ha,depthBuffer:e})}function Ya(i,t,e){return new rs({name:i,uniforms:t,vertexShader:me.cube_vert,fragmentShader:e,side:ei,blending:xr,depthTest:!1,depthWrite:!1})}function Wb(){return Ya("PMREMGGXConvolution",{envMap:{value:null},roughness:{value:0},lodBias:{value:0}},`

		#define GGX_SAMPLES ${jg}u

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float roughness;
		uniform float lodBias;

		#include <common>

		// Van der Corput radical inverse
		float radicalInverse_VdC( uint bits ) {

			bits = ( bits << 16u ) | ( bits >> 16u );
			bits = ( ( bits & 0x55555555u ) << 1u ) | ( ( bits & 0xAAAAAAAAu ) >> 1u );
			bits = ( ( bits & 0x33333333u ) << 2u ) | ( ( bits & 0xCCCCCCCCu ) >> 2u );
			bits = ( ( bits & 0x0F0F0F0Fu ) << 4u ) | ( ( bits & 0xF0F0F0F0u ) >> 4u );
			bits = ( ( bits & 0x00FF00FFu ) << 8u ) | ( ( bits & 0xFF00FF00u ) >> 8u );
			return float( bits ) * 2.3283064365386963e-10; // / 0x100000000

		}

		// Hammersley sequence
		vec2 hammersley( uint i, uint N ) {

			return vec2( float( i ) / float( N ), radicalInverse_VdC( i ) );

		}

		void main() {

			vec3 N = normalize( vWorldDirection );

			// For very low roughness, just sample the environment directly
			if ( roughness < 0.001 ) {

				gl_FragColor = vec4( textureLod( envMap, N, 0.0 ).rgb, 1.0 );
				return;

			}

			float alpha = roughness * roughness;
			float alpha2 = alpha * alpha;

			// Tangent space basis for VNDF sampling
			vec3 up = abs( N.z ) < 0.999 ? vec3( 0.0, 0.0, 1.0 ) : vec3( 1.0, 0.0, 0.0 );
			vec3 tangent = normalize( cross( up, N ) );
			vec3 bitangent = cross( N, tangent );

			vec3 prefilteredColor = vec3( 0.0 );
			float totalWeight = 0.0;

			for ( uint i = 0u; i < GGX_SAMPLES; i ++ ) {

				vec2 Xi = hammersley( i, GGX_SAMPLES );

				// With V = N, sample the reflected direction directly.
				float invQ = 1.0 / ( 1.0 - Xi.x + alpha2 * Xi.x );
				float NdotL = ( 1.0 - Xi.x - alpha2 * Xi.x ) * invQ;

				if ( NdotL > 0.0 ) {

					float phi = 2.0 * PI * Xi.y;
					float sinTheta = 2.0 * alpha * sqrt( Xi.x * ( 1.0 - Xi.x ) ) * invQ;
					vec3 L = N * NdotL + ( tangent * cos( phi ) + bitangent * sin( phi ) ) * sinTheta;

					// Match the source mip to the sample's solid angle. The terms
					// independent of the sample are precomputed in lodBias.
					float d = alpha2 * invQ;
					float lod = max( log2( d ) + lodBias, 0.0 );

					// Weight by NdotL for the split-sum approximation
					prefilteredColor += textureLod( envMap, L, lod ).rgb * NdotL;
					totalWeight += NdotL;

				}

			}

			gl_FragColor = vec4( prefilteredColor / totalWeight, 1.0 );

		}
	`)}function Xb(){return Ya("PMREMGGXIntegration",{envMap:{value:null},roughness:{value:0},sourceLod:{value:0},sourceSize:{value:Qg}},`

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float roughness;
		uniform float sourceLod;
		uniform int sourceSize;

		void main() {

			vec3 N = normalize( vWorldDirection );

			float alpha = roughness * roughness;
			float alpha2 = alpha * alpha;

			float texelSize = 2.0 / float( sourceSize );

			vec3 prefilteredColor = vec3( 0.0 );
			float totalWeight = 0.0;

			// Pair opposite texels: only the one in N's hemisphere contributes.
			for ( int face = 0; face < 3; face ++ ) {

				for ( int y = 0; y < sourceSize; y ++ ) {

					for ( int x = 0; x < sourceSize; x ++ ) {

						vec2 uv = ( vec2( x, y ) + 0.5 ) * texelSize - 1.0;
						vec3 texelDirection = face == 0 ? vec3( 1.0, uv ) : ( face == 1 ? vec3( uv.x, 1.0, uv.y ) : vec3( uv, 1.0 ) );

						float invDistance = inversesqrt( 1.0 + dot( uv, uv ) );
						float NdotL = dot( N, texelDirection );
						texelDirection *= NdotL < 0.0 ? - 1.0 : 1.0;
						NdotL = abs( NdotL ) * invDistance;

						// With V = N, NdotH squared is ( 1 + NdotL ) / 2. Common factors
						// in the GGX distribution and texel solid angle cancel when normalized.
						float d = 1.0 + alpha2 + ( alpha2 - 1.0 ) * NdotL;
						float weight = NdotL * invDistance * invDistance * invDistance / ( d * d );

						prefilteredColor += textureLod( envMap, texelDirection, sourceLod ).rgb * weight;
						totalWeight += weight;

					}

				}

			}

			gl_FragColor = vec4( prefilteredColor / totalWeight, 1.0 );

		}
	`)}function qb(){return Ya("PMREMSphericalGaussianBlur",{envMap:{value:null},sigma:{value:0}},`

		#define SAMPLES ${zb}
		#define GOLDEN_ANGLE 2.39996322973

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float sigma;

		#include <common>

		void main() {

			vec3 outputDirection = normalize( vWorldDirection );

			vec3 up = abs( outputDirection.z ) < 0.999 ? vec3( 0.0, 0.0, 1.0 ) : vec3( 1.0, 0.0, 0.0 );
			vec3 tangent = normalize( cross( up, outputDirection ) );
			vec3 bitangent = cross( outputDirection, tangent );

			// Truncate the kernel at three standard deviations or at the antipode.
			float thetaMax = min( 3.0 * sigma, PI );
			float truncation = 1.0 - exp( - 0.5 * thetaMax * thetaMax / ( sigma * sigma ) );

			vec3 accumColor = vec3( 0.0 );
			float accumWeight = 0.0;

			for ( int i = 0; i < SAMPLES; i ++ ) {

				// Stratified inverse-CDF sampling of the Gaussian, placed on a golden-angle spiral.
				float stratum = ( float( i ) + 0.5 ) / float( SAMPLES );
				float theta = sigma * sqrt( - 2.0 * log( 1.0 - stratum * truncation ) );
				float phi = float( i ) * GOLDEN_ANGLE;

				vec3 offset = cos( phi ) * tangent + sin( phi ) * bitangent;
				vec3 sampleDirection = cos( theta ) * outputDirection + sin( theta ) * offset;

				// Correct the planar sample density to solid angle.
				float weight = sin( theta ) / theta;

				accumColor += weight * textureLod( envMap, sampleDirection, 0.0 ).rgb;
				accumWeight += weight;

			}

			gl_FragColor = vec4( accumColor / accumWeight, 1.0 );

		}
	`)}function Ig(){return Ya("PMREMEquirectangularToCubemap",{envMap:{value:null}},`

		varying vec3 vWorldDirection;

		uniform sampler2D envMap;

		#include <common>

		void main() {

			// Average four subpixel samples to preserve small, bright features.
			vec3 direction = normalize( vWorldDirection );
			vec3 dx = dFdx( direction ) * 0.25;
			vec3 dy = dFdy( direction ) * 0.25;

			vec3 color = textureLod( envMap, equirectUv( normalize( direction - dx - dy ) ), 0.0 ).rgb;
			color += textureLod( envMap, equirectUv( normalize( direction + dx - dy ) ), 0.0 ).rgb;
			color += textureLod( envMap, equirectUv( normalize( direction - dx + dy ) ), 0.0 ).rgb;
			color += textureLod( envMap, equirectUv( normalize( direction + dx + dy ) ), 0.0 ).rgb;
			gl_FragColor = vec4( color * 0.25, 1.0 );

		}
	`)}function Lg(){return Ya("PMREMCubemapToCubemap",{envMap:{value:null},flipEnvMap:{value:-1}},`

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float flipEnvMap;

		void main() {

			gl_FragColor = vec4( textureCube( envMap, vec3( flipEnvMap * vWorldDirection.x, vWorldDirection.yz ) ).rgb, 1.0 );

		}
	`)}function $b(i){let t=new WeakMap,e=new WeakMap,n=null;function s(h,d=!1){return h==null?null:d?o(h):r(h)}function r(h){if(h&&h.isTexture){let d=h.mapping;if(d===Xc||d===qc)if(t.has(h)){let p=t.get(h).texture;return a(p,h.mapping)}else{let p=h.image;if(p&&p.height>0){let _=new $a(p.height);return _.fromEquirectangularTexture(i,h),t.set(h,_),h.addEventListener("dispose",c),a(_.texture,h.mapping)}else return null}}return h}function o(h){if(h&&h.isTexture&&h.isPMREMTexture!==!0){let d=h.mapping,p=d===Xc||d===qc,_=d===vr||d===To;if(p||_){let g=e.get(h),m=g!==void 0?g.texture.pmremVersion:0;if(h.isRenderTargetTexture&&h.pmremVersion!==m)return n===null&&(n=new Nh(i)),g=p?n.fromEquirectangular(h,g):n.fromCubemap(h,g),g.texture.pmremVersion=h.pmremVersion,e.set(h,g),g.texture;if(g!==void 0)return g.texture;{let v=h.image;return p&&v&&v.height>0||_&&v&&l(v)?(n===null&&(n=new Nh(i)),g=p?n.fromEquirectangular(h):n.fromCubemap(h),g.texture.pmremVersion=h.pmremVersion,e.set(h,g),h.addEventListener("dispose",f),g.texture):null}}}return h}function a(h,d){return d===Xc?h.mapping=vr:d===qc&&(h.mapping=To),h}function l(h){let d=0,p=6;for(let _=0;_<p;_++)h[_]!==void 0&&d++;return d===p}function c(h){let d=h.target;d.removeEventListener("dispose",c);let p=t.get(d);p!==void 0&&(t.delete(d),p.dispose())}function f(h){let d=h.target;d.removeEventListener("dispose",f);let p=e.get(d);p!==void 0&&(e.delete(d),p.dispose())}function u(){t=new WeakMap,e=new WeakMap,n!==null&&(n.dispose(),n=null)}return{get:s,dispose:u}}function Yb(i){let t={};function e(n){if(t[n]!==void 0)return t[n];let s=i.getExtension(n);return t[n]=s,s}return{has:function(n){return e(n)!==null},init:function(){e("EXT_color_buffer_float"),e("WEBGL_clip_cull_distance"),e("OES_texture_float_linear"),e("EXT_color_buffer_half_float"),e("WEBGL_multisampled_render_to_texture"),e("WEBGL_render_shared_exponent")},get:function(n){let s=e(n);return s===null&&aa("WebGLRenderer: "+n+" extension not supported."),s}}}function Zb(i,t,e,n){let s={},r=new WeakMap,o=new FinalizationRegistry(p=>delete s[p]);function a(p){l(p.target)}function l(p){p.index!==null&&t.remove(p.index);for(let g in p.attributes)t.remove(p.attributes[g]);p.removeEventListener("dispose",a),delete s[p.id],o.unregister(p);let _=r.get(p);_&&(t.remove(_),r.delete(p)),n.releaseStatesOfGeometry(p),p.isInstancedBufferGeometry===!0&&delete p._maxInstanceCount,e.memory.geometries--}function c(p,_){return s[_.id]!==void 0||(_.addEventListener("dispose",a),s[_.id]=new WeakRef(_),o.register(_,_.id,_),e.memory.geometries++),_}function f(p){let _=p.attributes;for(let g in _)t.update(_[g],i.ARRAY_BUFFER)}function u(p){let _=p.index,g=p.attributes.position,m=0;if(g===void 0)return;let v=_!==null?_.array.length:g.array.length/3-1,A=g.count>=65535?xa:_a,S=new A(Math.ceil(v/3)*6,1),R=S.array;if(_!==null){let x=_.array;m=_.version;for(let T=0,U=0;T<v;T+=3){let N=x[T+0],L=x[T+1],z=x[T+2];R[U++]=N,R[U++]=L,R[U++]=L,R[U++]=z,R[U++]=z,R[U++]=N}}else{m=g.version;for(let x=0,T=0;x<v;x+=3){let U=x+0,N=x+1,L=x+2;R[T++]=U,R[T++]=N,R[T++]=N,R[T++]=L,R[T++]=L,R[T++]=U}}S.version=m;let E=r.get(p);E&&t.remove(E),r.set(p,S)}function h(p){let _=r.get(p);if(_){let g=p.index;g!==null&&_.version<g.version&&u(p)}else u(p);return r.get(p)}function d(){for(let p in s){let _=s[p].deref();_!==void 0&&l(_)}}return{get:c,update:f,getWireframeAttribute:h,dispose:d}}function Jb(i,t,e){let n;function s(u){n=u}let r,o;function a(u){r=u.type,o=u.bytesPerElement}function l(u,h){i.drawElements(n,h,r,u*o),e.update(h,n,1)}function c(u,h,d){d!==0&&(i.drawElementsInstanced(n,h,r,u*o,d),e.update(h,n,d))}function f(u,h,d){if(d===0)return;t.get("WEBGL_multi_draw").multiDrawElementsWEBGL(n,h,0,r,u,0,d);let _=0;for(let g=0;g<d;g++)_+=h[g];e.update(_,n,1)}this.setMode=s,this.setIndex=a,this.render=l,this.renderInstances=c,this.renderMultiDraw=f}function Kb(i){let t={geometries:0,textures:0},e={frame:0,calls:0,triangles:0,points:0,lines:0};function n(r,o,a){switch(e.calls++,o){case i.TRIANGLES:e.triangles+=a*(r/3);break;case i.LINES:e.lines+=a*(r/2);break;case i.LINE_STRIP:e.lines+=a*(r-1);break;case i.LINE_LOOP:e.lines+=a*r;break;case i.POINTS:e.points+=a*r;break;default:se("WebGLInfo: Unknown draw mode:",o);break}}function s(){e.calls=0,e.triangles=0,e.points=0,e.lines=0}return{memory:t,render:e,programs:null,autoReset:!0,reset:s,update:n}}function jb(i,t,e){let n=new WeakMap,s=new Qe;function r(o,a,l){let c=o.morphTargetInfluences,f=a.morphAttributes.position||a.morphAttributes.normal||a.morphAttributes.color,u=f!==void 0?f.length:0,h=n.get(a);if(h===void 0||h.count!==u){let U=function(){x.dispose(),n.delete(a),a.removeEventListener("dispose",U)};h!==void 0&&h.texture.dispose();let d=a.morphAttributes.position!==void 0,p=a.morphAttributes.normal!==void 0,_=a.morphAttributes.color!==void 0,g=a.morphAttributes.position||[],m=a.morphAttributes.normal||[],v=a.morphAttributes.color||[],A=0;d===!0&&(A=1),p===!0&&(A=2),_===!0&&(A=3);let S=a.attributes.position.count*A,R=1;S>t.maxTextureSize&&(R=Math.ceil(S/t.maxTextureSize),S=t.maxTextureSize);let E=new Float32Array(S*R*4*u),x=new pa(E,S,R,u);x.type=ki,x.needsUpdate=!0;let T=A*4;for(let N=0;N<u;N++){let L=g[N],z=m[N],O=v[N],P=S*R*4*N;for(let G=0;G<L.count;G++){let q=G*T;d===!0&&(s.fromBufferAttribute(L,G),E[P+q+0]=s.x,E[P+q+1]=s.y,E[P+q+2]=s.z,E[P+q+3]=0),p===!0&&(s.fromBufferAttribute(z,G),E[P+q+4]=s.x,E[P+q+5]=s.y,E[P+q+6]=s.z,E[P+q+7]=0),_===!0&&(s.fromBufferAttribute(O,G),E[P+q+8]=s.x,E[P+q+9]=s.y,E[P+q+10]=s.z,E[P+q+11]=O.itemSize===4?s.w:1)}}h={count:u,texture:x,size:new Jt(S,R)},n.set(a,h),a.addEventListener("dispose",U)}if(o.isInstancedMesh===!0&&o.morphTexture!==null)l.getUniforms().setValue(i,"morphTexture",o.morphTexture,e);else{let d=0;for(let _=0;_<c.length;_++)d+=c[_];let p=a.morphTargetsRelative?1:1-d;l.getUniforms().setValue(i,"morphTargetBaseInfluence",p),l.getUniforms().setValue(i,"morphTargetInfluences",c)}l.getUniforms().setValue(i,"morphTargetsTexture",h.texture,e),l.getUniforms().setValue(i,"morphTargetsTextureSize",h.size)}return{update:r}}function Qb(i,t,e,n,s){let r=new WeakMap;function o(c){let f=s.render.frame,u=c.geometry,h=t.get(c,u);if(r.get(h)!==f&&(t.update(h),r.set(h,f)),c.isInstancedMesh&&(c.hasEventListener("dispose",l)===!1&&c.addEventListener("dispose",l),r.get(c)!==f&&(e.update(c.instanceMatrix,i.ARRAY_BUFFER),c.instanceColor!==null&&e.update(c.instanceColor,i.ARRAY_BUFFER),r.set(c,f))),c.isSkinnedMesh){let d=c.skeleton;r.get(d)!==f&&(d.update(),r.set(d,f))}return h}function a(){r=new WeakMap}function l(c){let f=c.target;f.removeEventListener("dispose",l),n.releaseStatesOfObject(f),e.remove(f.instanceMatrix),f.instanceColor!==null&&e.remove(f.instanceColor)}return{update:o,dispose:a}}var tw={[pf]:"LINEAR_TONE_MAPPING",[mf]:"REINHARD_TONE_MAPPING",[gf]:"CINEON_TONE_MAPPING",[_f]:"ACES_FILMIC_TONE_MAPPING",[yf]:"AGX_TONE_MAPPING",[vf]:"NEUTRAL_TONE_MAPPING",[xf]:"CUSTOM_TONE_MAPPING"};function ew(i,t,e,n,s,r){let o=new gi(t,e,{type:i,depthBuffer:s,stencilBuffer:r,samples:n?4:0,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,resolveDepthBuffer:!1,resolveStencilBuffer:!1}),a=null,l=null,c=null,f=new an;f.setAttribute("position",new Re([-1,3,0,-1,-1,0,3,-1,0],3)),f.setAttribute("uv",new Re([0,2,0,0,2,0],2));let u=new Pc({uniforms:{tDiffuse:{value:null}},vertexShader:`
			precision highp float;

			uniform mat4 modelViewMatrix;
			uniform mat4 projectionMatrix;

			attribute vec3 position;
			attribute vec2 uv;

			varying vec2 vUv;

			void main() {
				vUv = uv;
				gl_Position = projectionMatrix * modelViewMatrix * vec4( position, 1.0 );
			}`,fragmentShader:`
			precision highp float;

			uniform sampler2D tDiffuse;

			varying vec2 vUv;

			#include <tonemapping_pars_fragment>
			#include <colorspace_pars_fragment>

			void main() {
				gl_FragColor = texture2D( tDiffuse, vUv );

				#ifdef LINEAR_TONE_MAPPING
					gl_FragColor.rgb = LinearToneMapping( gl_FragColor.rgb );
				#elif defined( REINHARD_TONE_MAPPING )
					gl_FragColor.rgb = ReinhardToneMapping( gl_FragColor.rgb );
				#elif defined( CINEON_TONE_MAPPING )
					gl_FragColor.rgb = CineonToneMapping( gl_FragColor.rgb );
				#elif defined( ACES_FILMIC_TONE_MAPPING )
					gl_FragColor.rgb = ACESFilmicToneMapping( gl_FragColor.rgb );
				#elif defined( AGX_TONE_MAPPING )
					gl_FragColor.rgb = AgXToneMapping( gl_FragColor.rgb );
				#elif defined( NEUTRAL_TONE_MAPPING )
					gl_FragColor.rgb = NeutralToneMapping( gl_FragColor.rgb );
				#elif defined( CUSTOM_TONE_MAPPING )
					gl_FragColor.rgb = CustomToneMapping( gl_FragColor.rgb );
				#endif

				#ifdef SRGB_TRANSFER
					gl_FragColor = sRGBTransferOETF( gl_FragColor );
				#endif
			}`,depthTest:!1,depthWrite:!1}),h=new bn(f,u),d=new La(-1,1,1,-1,0,1),p=null,_=null,g=!1,m,v=null,A=[],S=!1;this.setSize=function(R,E){o.setSize(R,E),a!==null&&a.setSize(R,E),l!==null&&l.setSize(R,E);for(let x=0;x<A.length;x++){let T=A[x];T.setSize&&T.setSize(R,E)}},this.setEffects=function(R){A=R,S=A.length>0&&A[0].isRenderPass===!0;let E=o.width,x=o.height;A.length>0&&a===null&&(a=new gi(E,x,{type:zi,depthBuffer:!1,stencilBuffer:!1}),l=new gi(E,x,{type:zi,depthBuffer:!1,stencilBuffer:!1}));let T=s===!0&&A.some(U=>U.needsDepthTexture===!0);T!==(o.depthTexture!==null)&&(T===!0&&c===null&&(c=new Ts(E,x),r===!0&&(c.format=As,c.type=Sr)),o.dispose(),o.depthTexture=T?c:null,o.resolveDepthBuffer=T,o.storeMultisampledDepthBuffer=T);for(let U=0;U<A.length;U++){let N=A[U];N.setSize&&N.setSize(E,x),T&&N.needsDepthTexture===!0&&N.setDepthTexture&&N.setDepthTexture(c)}},this.begin=function(R,E){if(g||R.toneMapping===as&&A.length===0)return!1;if(v=E,E!==null){let x=E.width,T=E.height;(o.width!==x||o.height!==T)&&this.setSize(x,T)}return S===!1&&R.setRenderTarget(o),m=R.toneMapping,R.toneMapping=as,!0},this.hasRenderPass=function(){return S},this.end=function(R,E){R.toneMapping=m,g=!0;let x=o,T=a;for(let U=0;U<A.length;U++){let N=A[U];N.enabled!==!1&&(N.render(R,T,x,E),N.needsSwap!==!1&&(x=T,T=T===a?l:a))}if(p!==R.outputColorSpace||_!==R.toneMapping){p=R.outputColorSpace,_=R.toneMapping,u.defines={},Me.getTransfer(p)===Le&&(u.defines.SRGB_TRANSFER="");let U=tw[_];U&&(u.defines[U]=""),u.needsUpdate=!0}u.uniforms.tDiffuse.value=x.texture,R.setRenderTarget(v),R.render(h,d),v=null,g=!1},this.isCompositing=function(){return g},this.dispose=function(){o.dispose(),a!==null&&a.dispose(),l!==null&&l.dispose(),f.dispose(),u.dispose()}}var t0=new ti,e0=new Ts(1,1),n0=new ba(1),i0=new pa,s0=new wc,r0=new Sa,Dg=[],Ng=[],Ug=new Float32Array(16),Fg=new Float32Array(9),Og=new Float32Array(4);function Co(i,t,e){let n=i[0];if(n<=0||n>0)return i;let s=t*e,r=Dg[s];if(r===void 0&&(r=new Float32Array(s),Dg[s]=r),t!==0){n.toArray(r,0);for(let o=1,a=0;o!==t;++o)a+=e,i[o].toArray(r,a)}return r}function wn(i,t){if(i.length!==t.length)return!1;for(let e=0,n=i.length;e<n;e++)if(i[e]!==t[e])return!1;return!0}function Tn(i,t){for(let e=0,n=t.length;e<n;e++)i[e]=t[e]}function Fh(i,t){let e=Ng[t];e===void 0&&(e=new Int32Array(t),Ng[t]=e);for(let n=0;n!==t;++n)e[n]=i.allocateTextureUnit();return e}function nw(i,t){let e=this.cache;e[0]!==t&&(i.uniform1f(this.addr,t),e[0]=t)}function iw(i,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y)&&(i.uniform2f(this.addr,t.x,t.y),e[0]=t.x,e[1]=t.y);else{if(wn(e,t))return;i.uniform2fv(this.addr,t),Tn(e,t)}}function sw(i,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z)&&(i.uniform3f(this.addr,t.x,t.y,t.z),e[0]=t.x,e[1]=t.y,e[2]=t.z);else if(t.r!==void 0)(e[0]!==t.r||e[1]!==t.g||e[2]!==t.b)&&(i.uniform3f(this.addr,t.r,t.g,t.b),e[0]=t.r,e[1]=t.g,e[2]=t.b);else{if(wn(e,t))return;i.uniform3fv(this.addr,t),Tn(e,t)}}function rw(i,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z||e[3]!==t.w)&&(i.uniform4f(this.addr,t.x,t.y,t.z,t.w),e[0]=t.x,e[1]=t.y,e[2]=t.z,e[3]=t.w);else{if(wn(e,t))return;i.uniform4fv(this.addr,t),Tn(e,t)}}function ow(i,t){let e=this.cache,n=t.elements;if(n===void 0){if(wn(e,t))return;i.uniformMatrix2fv(this.addr,!1,t),Tn(e,t)}else{if(wn(e,n))return;Og.set(n),i.uniformMatrix2fv(this.addr,!1,Og),Tn(e,n)}}function aw(i,t){let e=this.cache,n=t.elements;if(n===void 0){if(wn(e,t))return;i.uniformMatrix3fv(this.addr,!1,t),Tn(e,t)}else{if(wn(e,n))return;Fg.set(n),i.uniformMatrix3fv(this.addr,!1,Fg),Tn(e,n)}}function lw(i,t){let e=this.cache,n=t.elements;if(n===void 0){if(wn(e,t))return;i.uniformMatrix4fv(this.addr,!1,t),Tn(e,t)}else{if(wn(e,n))return;Ug.set(n),i.uniformMatrix4fv(this.addr,!1,Ug),Tn(e,n)}}function cw(i,t){let e=this.cache;e[0]!==t&&(i.uniform1i(this.addr,t),e[0]=t)}function hw(i,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y)&&(i.uniform2i(this.addr,t.x,t.y),e[0]=t.x,e[1]=t.y);else{if(wn(e,t))return;i.uniform2iv(this.addr,t),Tn(e,t)}}function uw(i,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z)&&(i.uniform3i(this.addr,t.x,t.y,t.z),e[0]=t.x,e[1]=t.y,e[2]=t.z);else{if(wn(e,t))return;i.uniform3iv(this.addr,t),Tn(e,t)}}function fw(i,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z||e[3]!==t.w)&&(i.uniform4i(this.addr,t.x,t.y,t.z,t.w),e[0]=t.x,e[1]=t.y,e[2]=t.z,e[3]=t.w);else{if(wn(e,t))return;i.uniform4iv(this.addr,t),Tn(e,t)}}function dw(i,t){let e=this.cache;e[0]!==t&&(i.uniform1ui(this.addr,t),e[0]=t)}function pw(i,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y)&&(i.uniform2ui(this.addr,t.x,t.y),e[0]=t.x,e[1]=t.y);else{if(wn(e,t))return;i.uniform2uiv(this.addr,t),Tn(e,t)}}function mw(i,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z)&&(i.uniform3ui(this.addr,t.x,t.y,t.z),e[0]=t.x,e[1]=t.y,e[2]=t.z);else{if(wn(e,t))return;i.uniform3uiv(this.addr,t),Tn(e,t)}}function gw(i,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z||e[3]!==t.w)&&(i.uniform4ui(this.addr,t.x,t.y,t.z,t.w),e[0]=t.x,e[1]=t.y,e[2]=t.z,e[3]=t.w);else{if(wn(e,t))return;i.uniform4uiv(this.addr,t),Tn(e,t)}}function Oh(i){return i.version===0&&(i.compareFunction=If,i.needsUpdate=!0),i}function _w(i,t,e){let n=this.cache,s=e.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s);let r;this.type===i.SAMPLER_2D_SHADOW?r=Oh(e0):r=t0,e.setTexture2D(t||r,s)}function xw(i,t,e){let n=this.cache,s=e.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s),e.setTexture3D(t||s0,s)}function yw(i,t,e){let n=this.cache,s=e.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s);let r;this.type===i.SAMPLER_CUBE_SHADOW?r=Oh(n0):r=r0,e.setTextureCube(t||r,s)}function vw(i,t,e){let n=this.cache,s=e.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s),e.setTexture2DArray(t||i0,s)}function Sw(i){switch(i){case 5126:return nw;case 35664:return iw;case 35665:return sw;case 35666:return rw;case 35674:return ow;case 35675:return aw;case 35676:return lw;case 5124:case 35670:return cw;case 35667:case 35671:return hw;case 35668:case 35672:return uw;case 35669:case 35673:return fw;case 5125:return dw;case 36294:return pw;case 36295:return mw;case 36296:return gw;case 35678:case 36198:case 36298:case 36306:case 35682:return _w;case 35679:case 36299:case 36307:return xw;case 35680:case 36300:case 36308:case 36293:return yw;case 36289:case 36303:case 36311:case 36292:return vw}}function Mw(i,t){i.uniform1fv(this.addr,t)}function bw(i,t){let e=Co(t,this.size,2);i.uniform2fv(this.addr,e)}function ww(i,t){let e=Co(t,this.size,3);i.uniform3fv(this.addr,e)}function Tw(i,t){let e=Co(t,this.size,4);i.uniform4fv(this.addr,e)}function Ew(i,t){let e=Co(t,this.size,4);i.uniformMatrix2fv(this.addr,!1,e)}function Aw(i,t){let e=Co(t,this.size,9);i.uniformMatrix3fv(this.addr,!1,e)}function Cw(i,t){let e=Co(t,this.size,16);i.uniformMatrix4fv(this.addr,!1,e)}function Rw(i,t){i.uniform1iv(this.addr,t)}function Pw(i,t){i.uniform2iv(this.addr,t)}function Iw(i,t){i.uniform3iv(this.addr,t)}function Lw(i,t){i.uniform4iv(this.addr,t)}function Dw(i,t){i.uniform1uiv(this.addr,t)}function Nw(i,t){i.uniform2uiv(this.addr,t)}function Uw(i,t){i.uniform3uiv(this.addr,t)}function Fw(i,t){i.uniform4uiv(this.addr,t)}function Ow(i,t,e){let n=this.cache,s=t.length,r=Fh(e,s);wn(n,r)||(i.uniform1iv(this.addr,r),Tn(n,r));let o;this.type===i.SAMPLER_2D_SHADOW?o=Oh(e0):o=t0;for(let a=0;a!==s;++a)e.setTexture2D(t[a]||o,r[a])}function Bw(i,t,e){let n=this.cache,s=t.length,r=Fh(e,s);wn(n,r)||(i.uniform1iv(this.addr,r),Tn(n,r));for(let o=0;o!==s;++o)e.setTexture3D(t[o]||s0,r[o])}function kw(i,t,e){let n=this.cache,s=t.length,r=Fh(e,s);wn(n,r)||(i.uniform1iv(this.addr,r),Tn(n,r));let o;this.type===i.SAMPLER_CUBE_SHADOW?o=Oh(n0):o=r0;for(let a=0;a!==s;++a)e.setTextureCube(t[a]||o,r[a])}function zw(i,t,e){let n=this.cache,s=t.length,r=Fh(e,s);wn(n,r)||(i.uniform1iv(this.addr,r),Tn(n,r));for(let o=0;o!==s;++o)e.setTexture2DArray(t[o]||i0,r[o])}function Vw(i){switch(i){case 5126:return Mw;case 35664:return bw;case 35665:return ww;case 35666:return Tw;case 35674:return Ew;case 35675:return Aw;case 35676:return Cw;case 5124:case 35670:return Rw;case 35667:case 35671:return Pw;case 35668:case 35672:return Iw;case 35669:case 35673:return Lw;case 5125:return Dw;case 36294:return Nw;case 36295:return Uw;case 36296:return Fw;case 35678:case 36198:case 36298:case 36306:case 35682:return Ow;case 35679:case 36299:case 36307:return Bw;case 35680:case 36300:case 36308:case 36293:return kw;case 36289:case 36303:case 36311:case 36292:return zw}}var Xf=class{constructor(t,e,n){this.id=t,this.addr=n,this.cache=[],this.type=e.type,this.setValue=Sw(e.type)}},qf=class{constructor(t,e,n){this.id=t,this.addr=n,this.cache=[],this.type=e.type,this.size=e.size,this.setValue=Vw(e.type)}},$f=class{constructor(t){this.id=t,this.seq=[],this.map={}}setValue(t,e,n){let s=this.seq;for(let r=0,o=s.length;r!==o;++r){let a=s[r];a.setValue(t,e[a.id],n)}}},Hf=/(\w+)(\])?(\[|\.)?/g;function Bg(i,t){i.seq.push(t),i.map[t.id]=t}function Gw(i,t,e){let n=i.name,s=n.length;for(Hf.lastIndex=0;;){let r=Hf.exec(n),o=Hf.lastIndex,a=r[1],l=r[2]==="]",c=r[3];if(l&&(a=a|0),c===void 0||c==="["&&o+2===s){Bg(e,c===void 0?new Xf(a,i,t):new qf(a,i,t));break}else{let u=e.map[a];u===void 0&&(u=new $f(a),Bg(e,u)),e=u}}}var Ao=class{constructor(t,e){this.seq=[],this.map={};let n=t.getProgramParameter(e,t.ACTIVE_UNIFORMS);for(let o=0;o<n;++o){let a=t.getActiveUniform(e,o),l=t.getUniformLocation(e,a.name);Gw(a,l,this)}let s=[],r=[];for(let o of this.seq)o.type===t.SAMPLER_2D_SHADOW||o.type===t.SAMPLER_CUBE_SHADOW||o.type===t.SAMPLER_2D_ARRAY_SHADOW?s.push(o):r.push(o);s.length>0&&(this.seq=s.concat(r))}setValue(t,e,n,s){let r=this.map[e];r!==void 0&&r.setValue(t,n,s)}setOptional(t,e,n){let s=e[n];s!==void 0&&this.setValue(t,n,s)}static upload(t,e,n,s){for(let r=0,o=e.length;r!==o;++r){let a=e[r],l=n[a.id];l.needsUpdate!==!1&&a.setValue(t,l.value,s)}}static seqWithValue(t,e){let n=[];for(let s=0,r=t.length;s!==r;++s){let o=t[s];o.id in e&&n.push(o)}return n}};function kg(i,t,e){let n=i.createShader(t);return i.shaderSource(n,e),i.compileShader(n),n}var Hw=37297,Ww=0;function Xw(i,t){let e=i.split(`
`),n=[],s=Math.max(t-6,0),r=Math.min(t+6,e.length);for(let o=s;o<r;o++){let a=o+1;n.push(`${a===t?">":" "} ${a}: ${e[o]}`)}return n.join(`
`)}var zg=new oe;function qw(i){Me._getMatrix(zg,Me.workingColorSpace,i);let t=`mat3( ${zg.elements.map(e=>e.toFixed(4))} )`;switch(Me.getTransfer(i)){case ua:return[t,"LinearTransferOETF"];case Le:return[t,"sRGBTransferOETF"];default:return jt("WebGLProgram: Unsupported color space: ",i),[t,"LinearTransferOETF"]}}function Vg(i,t,e){let n=i.getShaderParameter(t,i.COMPILE_STATUS),r=(i.getShaderInfoLog(t)||"").trim();if(n&&r==="")return"";let o=/ERROR: 0:(\d+)/.exec(r);if(o){let a=parseInt(o[1]);return e.toUpperCase()+`

`+r+`

`+Xw(i.getShaderSource(t),a)}else return r}function $w(i,t){let e=qw(t);return[`vec4 ${i}( vec4 value ) {`,`	return ${e[1]}( vec4( ${e[0]} * value.rgb, value.a ) );`,"}"].join(`
`)}var Yw={[pf]:"Linear",[mf]:"Reinhard",[gf]:"Cineon",[_f]:"ACESFilmic",[yf]:"AgX",[vf]:"Neutral",[xf]:"Custom"};function Zw(i,t){let e=Yw[t];return e===void 0?(jt("WebGLProgram: Unsupported toneMapping:",t),"vec3 "+i+"( vec3 color ) { return LinearToneMapping( color ); }"):"vec3 "+i+"( vec3 color ) { return "+e+"ToneMapping( color ); }"}var Dh=new X;function Jw(){Me.getLuminanceCoefficients(Dh);let i=Dh.x.toFixed(4),t=Dh.y.toFixed(4),e=Dh.z.toFixed(4);return["float luminance( const in vec3 rgb ) {",`	const vec3 weights = vec3( ${i}, ${t}, ${e} );`,"	return dot( weights, rgb );","}"].join(`
`)}function Kw(i){return[i.extensionClipCullDistance?"#extension GL_ANGLE_clip_cull_distance : require":"",i.extensionMultiDraw?"#extension GL_ANGLE_multi_draw : require":""].filter(qa).join(`
`)}function jw(i){let t=[];for(let e in i){let n=i[e];n!==!1&&t.push("#define "+e+" "+n)}return t.join(`
`)}function Qw(i,t){let e={},n=i.getProgramParameter(t,i.ACTIVE_ATTRIBUTES);for(let s=0;s<n;s++){let r=i.getActiveAttrib(t,s),o=r.name,a=1;r.type===i.FLOAT_MAT2&&(a=2),r.type===i.FLOAT_MAT3&&(a=3),r.type===i.FLOAT_MAT4&&(a=4),e[o]={type:r.type,location:i.getAttribLocation(t,o),locationSize:a}}return e}function qa(i){return i!==""}function Gg(i,t){let e=t.numSpotLightShadows+t.numSpotLightMaps-t.numSpotLightShadowsWithMaps;return i.replace(/NUM_SUN_LIGHTS/g,t.numSunLights).replace(/NUM_DIR_LIGHTS/g,t.numDirLights).replace(/NUM_SPOT_LIGHTS/g,t.numSpotLights).replace(/NUM_SPOT_LIGHT_MAPS/g,t.numSpotLightMaps).replace(/NUM_SPOT_LIGHT_COORDS/g,e).replace(/NUM_RECT_AREA_LIGHTS/g,t.numRectAreaLights).replace(/NUM_POINT_LIGHTS/g,t.numPointLights).replace(/NUM_HEMI_LIGHTS/g,t.numHemiLights).replace(/NUM_SUN_LIGHT_SHADOWS/g,t.numSunLightShadows).replace(/NUM_DIR_LIGHT_SHADOWS/g,t.numDirLightShadows).replace(/NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS/g,t.numSpotLightShadowsWithMaps).replace(/NUM_SPOT_LIGHT_SHADOWS/g,t.numSpotLightShadows).replace(/NUM_POINT_LIGHT_SHADOWS/g,t.numPointLightShadows).replace(/NUM_LIGHT_PROBE_GRIDS/g,t.numLightProbeGrids)}function Hg(i,t){return i.replace(/NUM_CLIPPING_PLANES/g,t.numClippingPlanes).replace(/UNION_CLIPPING_PLANES/g,t.numClippingPlanes-t.numClipIntersection)}var tT=/^[ \t]*#include +<([\w\d./]+)>/gm;function Yf(i){return i.replace(tT,eT)}function eT(i,t){let e=me[t];if(e===void 0)throw new Error("THREE.WebGLProgram: Can not resolve #include <"+t+">");return Yf(e)}var nT=/#pragma unroll_loop_start\s+for\s*\(\s*int\s+i\s*=\s*(\d+)\s*;\s*i\s*<\s*(\d+)\s*;\s*i\s*\+\+\s*\)\s*{([\s\S]+?)}\s+#pragma unroll_loop_end/g;function Wg(i){return i.replace(nT,iT)}function iT(i,t,e,n){let s="";for(let r=parseInt(t);r<parseInt(e);r++)s+=n.replace(/\[\s*i\s*\]/g,"[ "+r+" ]").replace(/UNROLLED_LOOP_INDEX/g,r);return s}function Xg(i){let t=`precision ${i.precision} float;
	precision ${i.precision} int;
	precision ${i.precision} sampler2D;
	precision ${i.precision} samplerCube;
	precision ${i.precision} sampler3D;
	precision ${i.precision} sampler2DArray;
	precision ${i.precision} sampler2DShadow;
	precision ${i.precision} samplerCubeShadow;
	precision ${i.precision} sampler2DArrayShadow;
	precision ${i.precision} isampler2D;
	precision ${i.precision} isampler3D;
	precision ${i.precision} isamplerCube;
	precision ${i.precision} isampler2DArray;
	precision ${i.precision} usampler2D;
	precision ${i.precision} usampler3D;
	precision ${i.precision} usamplerCube;
	precision ${i.precision} usampler2DArray;
	`;return i.precision==="highp"?t+=`
#define HIGH_PRECISION`:i.precision==="mediump"?t+=`
#define MEDIUM_PRECISION`:i.precision==="lowp"&&(t+=`
#define LOW_PRECISION`),t}var sT={[Oa]:"SHADOWMAP_TYPE_PCF",[bo]:"SHADOWMAP_TYPE_VSM"};function rT(i){return sT[i.shadowMapType]||"SHADOWMAP_TYPE_BASIC"}var oT={[To]:"ENVMAP_MODE_REFRACTION"};function aT(i){return i.envMap===!1?"ENVMAP_MODE_REFLECTION":oT[i.envMapMode]||"ENVMAP_MODE_REFLECTION"}var lT={[df]:"ENVMAP_BLENDING_MULTIPLY",[cg]:"ENVMAP_BLENDING_MIX",[hg]:"ENVMAP_BLENDING_ADD"};function cT(i){return i.envMap===!1?"ENVMAP_BLENDING_NONE":lT[i.combine]||"ENVMAP_BLENDING_NONE"}function hT(i,t,e,n){let s=i.getContext(),r=e.defines,o=e.vertexShader,a=e.fragmentShader,l=rT(e),c=e.envMapPMREM===!0?"ENVMAP_TYPE_PMREM":"ENVMAP_TYPE_CUBE",f=aT(e),u=cT(e),h=Kw(e),d=jw(r),p=s.createProgram(),_,g,m=e.glslVersion?"#version "+e.glslVersion+`
`:"";e.isRawShaderMaterial?(_=["#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,d].filter(qa).join(`
`),_.length>0&&(_+=`
`),g=["#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,d].filter(qa).join(`
`),g.length>0&&(g+=`
`)):(_=[Xg(e),"#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,d,e.extensionClipCullDistance?"#define USE_CLIP_DISTANCE":"",e.batching?"#define USE_BATCHING":"",e.batchingColor?"#define USE_BATCHING_COLOR":"",e.instancing?"#define USE_INSTANCING":"",e.instancingColor?"#define USE_INSTANCING_COLOR":"",e.instancingMorph?"#define USE_INSTANCING_MORPH":"",e.useFog&&e.fog?"#define USE_FOG":"",e.useFog&&e.fogExp2?"#define FOG_EXP2":"",e.map?"#define USE_MAP":"",e.envMap?"#define USE_ENVMAP":"",e.envMap?"#define "+f:"",e.lightMap?"#define USE_LIGHTMAP":"",e.aoMap?"#define USE_AOMAP":"",e.bumpMap?"#define USE_BUMPMAP":"",e.normalMap?"#define USE_NORMALMAP":"",e.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",e.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",e.displacementMap?"#define USE_DISPLACEMENTMAP":"",e.emissiveMap?"#define USE_EMISSIVEMAP":"",e.anisotropy?"#define USE_ANISOTROPY":"",e.anisotropyMap?"#define USE_ANISOTROPYMAP":"",e.clearcoatMap?"#define USE_CLEARCOATMAP":"",e.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",e.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",e.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",e.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",e.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",e.specularMap?"#define USE_SPECULARMAP":"",e.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",e.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",e.roughnessMap?"#define USE_ROUGHNESSMAP":"",e.metalnessMap?"#define USE_METALNESSMAP":"",e.alphaMap?"#define USE_ALPHAMAP":"",e.alphaHash?"#define USE_ALPHAHASH":"",e.transmission?"#define USE_TRANSMISSION":"",e.transmissionMap?"#define USE_TRANSMISSIONMAP":"",e.thicknessMap?"#define USE_THICKNESSMAP":"",e.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",e.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",e.mapUv?"#define MAP_UV "+e.mapUv:"",e.alphaMapUv?"#define ALPHAMAP_UV "+e.alphaMapUv:"",e.lightMapUv?"#define LIGHTMAP_UV "+e.lightMapUv:"",e.aoMapUv?"#define AOMAP_UV "+e.aoMapUv:"",e.emissiveMapUv?"#define EMISSIVEMAP_UV "+e.emissiveMapUv:"",e.bumpMapUv?"#define BUMPMAP_UV "+e.bumpMapUv:"",e.normalMapUv?"#define NORMALMAP_UV "+e.normalMapUv:"",e.displacementMapUv?"#define DISPLACEMENTMAP_UV "+e.displacementMapUv:"",e.metalnessMapUv?"#define METALNESSMAP_UV "+e.metalnessMapUv:"",e.roughnessMapUv?"#define ROUGHNESSMAP_UV "+e.roughnessMapUv:"",e.anisotropyMapUv?"#define ANISOTROPYMAP_UV "+e.anisotropyMapUv:"",e.clearcoatMapUv?"#define CLEARCOATMAP_UV "+e.clearcoatMapUv:"",e.clearcoatNormalMapUv?"#define CLEARCOAT_NORMALMAP_UV "+e.clearcoatNormalMapUv:"",e.clearcoatRoughnessMapUv?"#define CLEARCOAT_ROUGHNESSMAP_UV "+e.clearcoatRoughnessMapUv:"",e.diffuseRoughnessMapUv?"#define DIFFUSE_ROUGHNESSMAP_UV "+e.diffuseRoughnessMapUv:"",e.iridescenceMapUv?"#define IRIDESCENCEMAP_UV "+e.iridescenceMapUv:"",e.iridescenceThicknessMapUv?"#define IRIDESCENCE_THICKNESSMAP_UV "+e.iridescenceThicknessMapUv:"",e.sheenColorMapUv?"#define SHEEN_COLORMAP_UV "+e.sheenColorMapUv:"",e.sheenRoughnessMapUv?"#define SHEEN_ROUGHNESSMAP_UV "+e.sheenRoughnessMapUv:"",e.specularMapUv?"#define SPECULARMAP_UV "+e.specularMapUv:"",e.specularColorMapUv?"#define SPECULAR_COLORMAP_UV "+e.specularColorMapUv:"",e.specularIntensityMapUv?"#define SPECULAR_INTENSITYMAP_UV "+e.specularIntensityMapUv:"",e.transmissionMapUv?"#define TRANSMISSIONMAP_UV "+e.transmissionMapUv:"",e.thicknessMapUv?"#define THICKNESSMAP_UV "+e.thicknessMapUv:"",e.vertexTangents&&e.flatShading===!1?"#define USE_TANGENT":"",e.vertexNormals?"#define HAS_NORMAL":"",e.vertexColors?"#define USE_COLOR":"",e.vertexAlphas?"#define USE_COLOR_ALPHA":"",e.vertexUv1s?"#define USE_UV1":"",e.vertexUv2s?"#define USE_UV2":"",e.vertexUv3s?"#define USE_UV3":"",e.pointsUvs?"#define USE_POINTS_UV":"",e.flatShading?"#define FLAT_SHADED":"",e.skinning?"#define USE_SKINNING":"",e.morphTargets?"#define USE_MORPHTARGETS":"",e.morphNormals&&e.flatShading===!1?"#define USE_MORPHNORMALS":"",e.morphColors?"#define USE_MORPHCOLORS":"",e.morphTargetsCount>0?"#define MORPHTARGETS_TEXTURE_STRIDE "+e.morphTextureStride:"",e.morphTargetsCount>0?"#define MORPHTARGETS_COUNT "+e.morphTargetsCount:"",e.doubleSided?"#define DOUBLE_SIDED":"",e.flipSided?"#define FLIP_SIDED":"",e.shadowMapEnabled?"#define USE_SHADOWMAP":"",e.shadowMapEnabled?"#define "+l:"",e.sizeAttenuation?"#define USE_SIZEATTENUATION":"",e.numLightProbes>0?"#define USE_LIGHT_PROBES":"",e.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",e.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 modelMatrix;","uniform mat4 modelViewMatrix;","uniform mat4 projectionMatrix;","uniform mat4 viewMatrix;","uniform mat3 normalMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;","#ifdef USE_INSTANCING","	attribute mat4 instanceMatrix;","#endif","#ifdef USE_INSTANCING_COLOR","	attribute vec3 instanceColor;","#endif","#ifdef USE_INSTANCING_MORPH","	uniform sampler2D morphTexture;","#endif","attribute vec3 position;","attribute vec3 normal;","attribute vec2 uv;","#ifdef USE_UV1","	attribute vec2 uv1;","#endif","#ifdef USE_UV2","	attribute vec2 uv2;","#endif","#ifdef USE_UV3","	attribute vec2 uv3;","#endif","#ifdef USE_TANGENT","	attribute vec4 tangent;","#endif","#if defined( USE_COLOR_ALPHA )","	attribute vec4 color;","#elif defined( USE_COLOR )","	attribute vec3 color;","#endif","#ifdef USE_SKINNING","	attribute vec4 skinIndex;","	attribute vec4 skinWeight;","#endif",`
`].filter(qa).join(`
`),g=[Xg(e),"#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,d,e.useFog&&e.fog?"#define USE_FOG":"",e.useFog&&e.fogExp2?"#define FOG_EXP2":"",e.alphaToCoverage?"#define ALPHA_TO_COVERAGE":"",e.map?"#define USE_MAP":"",e.matcap?"#define USE_MATCAP":"",e.envMap?"#define USE_ENVMAP":"",e.envMap?"#define "+c:"",e.envMap?"#define "+f:"",e.envMap?"#define "+u:"",e.envMapPMREM?"#define ENVMAP_MAX_LOD "+e.envMapMaxLod+".0":"",e.envMapPMREM?"#define ENVMAP_SIZE "+e.envMapSize+".0":"",e.lightMap?"#define USE_LIGHTMAP":"",e.aoMap?"#define USE_AOMAP":"",e.bumpMap?"#define USE_BUMPMAP":"",e.normalMap?"#define USE_NORMALMAP":"",e.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",e.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",e.packedNormalMap?"#define USE_PACKED_NORMALMAP":"",e.emissiveMap?"#define USE_EMISSIVEMAP":"",e.anisotropy?"#define USE_ANISOTROPY":"",e.anisotropyMap?"#define USE_ANISOTROPYMAP":"",e.clearcoat?"#define USE_CLEARCOAT":"",e.clearcoatMap?"#define USE_CLEARCOATMAP":"",e.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",e.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",e.diffuseRoughness?"#define USE_DIFFUSE_ROUGHNESS":"",e.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",e.dispersion?"#define USE_DISPERSION":"",e.retroreflection?"#define USE_RETROREFLECTION":"",e.iridescence?"#define USE_IRIDESCENCE":"",e.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",e.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",e.specularMap?"#define USE_SPECULARMAP":"",e.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",e.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",e.roughnessMap?"#define USE_ROUGHNESSMAP":"",e.metalnessMap?"#define USE_METALNESSMAP":"",e.alphaMap?"#define USE_ALPHAMAP":"",e.alphaTest?"#define USE_ALPHATEST":"",e.alphaHash?"#define USE_ALPHAHASH":"",e.sheen?"#define USE_SHEEN":"",e.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",e.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",e.transmission?"#define USE_TRANSMISSION":"",e.transmissionMap?"#define USE_TRANSMISSIONMAP":"",e.thicknessMap?"#define USE_THICKNESSMAP":"",e.vertexTangents&&e.flatShading===!1?"#define USE_TANGENT":"",e.vertexColors||e.instancingColor?"#define USE_COLOR":"",e.vertexAlphas||e.batchingColor?"#define USE_COLOR_ALPHA":"",e.vertexUv1s?"#define USE_UV1":"",e.vertexUv2s?"#define USE_UV2":"",e.vertexUv3s?"#define USE_UV3":"",e.pointsUvs?"#define USE_POINTS_UV":"",e.gradientMap?"#define USE_GRADIENTMAP":"",e.flatShading?"#define FLAT_SHADED":"",e.doubleSided?"#define DOUBLE_SIDED":"",e.flipSided?"#define FLIP_SIDED":"",e.shadowMapEnabled?"#define USE_SHADOWMAP":"",e.shadowMapEnabled?"#define "+l:"",e.premultipliedAlpha?"#define PREMULTIPLIED_ALPHA":"",e.numLightProbes>0?"#define USE_LIGHT_PROBES":"",e.decodeVideoTexture?"#define DECODE_VIDEO_TEXTURE":"",e.decodeVideoTextureEmissive?"#define DECODE_VIDEO_TEXTURE_EMISSIVE":"",e.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",e.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 viewMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;",e.toneMapping!==as?"#define TONE_MAPPING":"",e.toneMapping!==as?me.tonemapping_pars_fragment:"",e.toneMapping!==as?Zw("toneMapping",e.toneMapping):"",e.dithering?"#define DITHERING":"",e.opaque?"#define OPAQUE":"",me.colorspace_pars_fragment,$w("linearToOutputTexel",e.outputColorSpace),Jw(),e.useDepthPacking?"#define DEPTH_PACKING "+e.depthPacking:"",`
`].filter(qa).join(`
`)),o=Yf(o),o=Gg(o,e),o=Hg(o,e),a=Yf(a),a=Gg(a,e),a=Hg(a,e),o=Wg(o),a=Wg(a),e.isRawShaderMaterial!==!0&&(m=`#version 300 es
`,_=[h,"#define attribute in","#define varying out","#define texture2D texture"].join(`
`)+`
`+_,g=["#define varying in",e.glslVersion===Df?"":"layout(location = 0) out highp vec4 pc_fragColor;",e.glslVersion===Df?"":"#define gl_FragColor pc_fragColor","#define gl_FragDepthEXT gl_FragDepth","#define texture2D texture","#define textureCube texture","#define texture2DProj textureProj","#define texture2DLodEXT textureLod","#define texture2DProjLodEXT textureProjLod","#define textureCubeLodEXT textureLod","#define texture2DGradEXT textureGrad","#define texture2DProjGradEXT textureProjGrad","#define textureCubeGradEXT textureGrad"].join(`
`)+`
`+g);let v=m+_+o,A=m+g+a,S=kg(s,s.VERTEX_SHADER,v),R=kg(s,s.FRAGMENT_SHADER,A);s.attachShader(p,S),s.attachShader(p,R),e.index0AttributeName!==void 0?s.bindAttribLocation(p,0,e.index0AttributeName):e.hasPositionAttribute===!0&&s.bindAttribLocation(p,0,"position"),s.linkProgram(p);function E(N){if(i.debug.checkShaderErrors){let L=s.getProgramInfoLog(p)||"",z=s.getShaderInfoLog(S)||"",O=s.getShaderInfoLog(R)||"",P=L.trim(),G=z.trim(),q=O.trim(),H=!0,ct=!0;if(s.getProgramParameter(p,s.LINK_STATUS)===!1)if(H=!1,typeof i.debug.onShaderError=="function")i.debug.onShaderError(s,p,S,R);else{let K=Vg(s,S,"vertex"),et=Vg(s,R,"fragment");se("WebGLProgram: Shader Error "+s.getError()+" - VALIDATE_STATUS "+s.getProgramParameter(p,s.VALIDATE_STATUS)+`

Material Name: `+N.name+`
Material Type: `+N.type+`

Program Info Log: `+P+`
`+K+`
`+et)}else P!==""?jt("WebGLProgram: Program Info Log:",P):(G===""||q==="")&&(ct=!1);ct&&(N.diagnostics={runnable:H,programLog:P,vertexShader:{log:G,prefix:_},fragmentShader:{log:q,prefix:g}})}s.deleteShader(S),s.deleteShader(R),x=new Ao(s,p),T=Qw(s,p)}let x;this.getUniforms=function(){return x===void 0&&E(this),x};let T;this.getAttributes=function(){return T===void 0&&E(this),T};let U=e.rendererExtensionParallelShaderCompile===!1;return this.isReady=function(){return U===!1&&(U=s.getProgramParameter(p,Hw)),U},this.destroy=function(){n.releaseStatesOfProgram(this),s.deleteProgram(p),this.program=void 0},this.type=e.shaderType,this.name=e.shaderName,this.id=Ww++,this.cacheKey=t,this.usedTimes=1,this.program=p,this.vertexShader=S,this.fragmentShader=R,this}var uT=0,Zf=class{constructor(){this.shaderCache=new Map,this.materialCache=new Map}update(t,e,n){let s=this._getShaderCacheForMaterial(t);return s.has(e)===!1&&(s.add(e),e.usedTimes++),s.has(n)===!1&&(s.add(n),n.usedTimes++),this}remove(t){let e=this.materialCache.get(t);for(let n of e)n.usedTimes--,n.usedTimes===0&&this.shaderCache.delete(n.code);return this.materialCache.delete(t),this}getVertexShaderStage(t){return this._getShaderStage(t.vertexShader)}getFragmentShaderStage(t){return this._getShaderStage(t.fragmentShader)}dispose(){this.shaderCache.clear(),this.materialCache.clear()}_getShaderCacheForMaterial(t){let e=this.materialCache,n=e.get(t);return n===void 0&&(n=new Set,e.set(t,n)),n}_getShaderStage(t){let e=this.shaderCache,n=e.get(t);return n===void 0&&(n=new Jf(t),e.set(t,n)),n}},Jf=class{constructor(t){this.id=uT++,this.code=t,this.usedTimes=0}};function fT(i){return i===Qs||i===Ha||i===Wa}function dT(i,t,e,n,s,r){let o=new ma,a=new Zf,l=new Set,c=[],f=new Map,u=n.logarithmicDepthBuffer,h={MeshDepthMaterial:"depth",MeshDistanceMaterial:"distance",MeshNormalMaterial:"normal",MeshBasicMaterial:"basic",MeshLambertMaterial:"lambert",MeshPhongMaterial:"phong",MeshToonMaterial:"toon",MeshStandardMaterial:"physical",MeshPhysicalMaterial:"physical",MeshMatcapMaterial:"matcap",LineBasicMaterial:"basic",LineDashedMaterial:"dashed",PointsMaterial:"points",ShadowMaterial:"shadow",SpriteMaterial:"sprite"};function d(x){return l.add(x),x===0?"uv":`uv${x}`}function p(x,T,U,N,L,z){let O=N.fog,P=L.geometry,G=x.isMeshStandardMaterial||x.isMeshLambertMaterial||x.isMeshPhongMaterial?N.environment:null,q=x.isMeshStandardMaterial||x.isMeshLambertMaterial&&!x.envMap||x.isMeshPhongMaterial&&!x.envMap,H=t.get(x.envMap||G,q),ct=h[x.type],K=n.precision;x.precision!==null&&(K=n.getMaxPrecision(x.precision),K!==x.precision&&jt("WebGLProgram.getParameters:",x.precision,"not supported, using",K,"instead."));let et=P.morphAttributes.position||P.morphAttributes.normal||P.morphAttributes.color,st=et!==void 0?et.length:0,pt=0;P.morphAttributes.position!==void 0&&(pt=1),P.morphAttributes.normal!==void 0&&(pt=2),P.morphAttributes.color!==void 0&&(pt=3);let dt,Q,_t,vt;if(ct){let It=cs[ct];dt=It.vertexShader,Q=It.fragmentShader}else{dt=x.vertexShader,Q=x.fragmentShader;let It=a.getVertexShaderStage(x),fe=a.getFragmentShaderStage(x);a.update(x,It,fe),_t=It.id,vt=fe.id}let Pt=i.getRenderTarget(),Tt=i.state.buffers.depth.getReversed(),Yt=L.isInstancedMesh===!0,ce=L.isBatchedMesh===!0,Xt=!!x.map,ge=!!x.matcap,de=!!H,ae=de&&H.isPMREMTexture===!0,Ke=!!x.aoMap,He=!!x.lightMap,un=!!x.bumpMap&&x.wireframe===!1,Be=!!x.normalMap,Rn=!!x.displacementMap,we=!!x.emissiveMap,yn=!!x.metalnessMap,en=!!x.roughnessMap,fn=x.anisotropy>0,k=x.clearcoat>0,Lt=x.diffuseRoughness>0,Qt=x.dispersion>0,he=x.retroreflectivity>0,Et=x.iridescence>0,ze=x.sheen>0,Wt=x.transmission>0,Kt=fn&&!!x.anisotropyMap,I=k&&!!x.clearcoatMap,M=k&&!!x.clearcoatNormalMap,$=k&&!!x.clearcoatRoughnessMap,ft=Lt&&!!x.diffuseRoughnessMap,at=Et&&!!x.iridescenceMap,yt=Et&&!!x.iridescenceThicknessMap,St=ze&&!!x.sheenColorMap,nt=ze&&!!x.sheenRoughnessMap,rt=!!x.specularMap,gt=!!x.specularColorMap,B=!!x.specularIntensityMap,ot=Wt&&!!x.transmissionMap,it=Wt&&!!x.thicknessMap,At=!!x.gradientMap,xt=!!x.alphaMap,wt=x.alphaTest>0,qt=!!x.alphaHash,ne=!!x.extensions,ut=as;x.toneMapped&&(Pt===null||Pt.isXRRenderTarget===!0)&&(ut=i.toneMapping);let Vt=ae?H.isCompressedCubeTexture?H.image[0].mipmaps:H.mipmaps:null,ie={shaderID:ct,shaderType:x.type,shaderName:x.name,vertexShader:dt,fragmentShader:Q,defines:x.defines,customVertexShaderID:_t,customFragmentShaderID:vt,isRawShaderMaterial:x.isRawShaderMaterial===!0,glslVersion:x.glslVersion,precision:K,batching:ce,batchingColor:ce&&L._colorsTexture!==null,instancing:Yt,instancingColor:Yt&&L.instanceColor!==null,instancingMorph:Yt&&L.morphTexture!==null,outputColorSpace:Pt===null?i.outputColorSpace:Pt.isXRRenderTarget===!0?Pt.texture.colorSpace:Me.workingColorSpace,alphaToCoverage:!!x.alphaToCoverage,map:Xt,matcap:ge,envMap:de,envMapMode:de&&H.mapping,envMapPMREM:ae,envMapMaxLod:ae?Vt.length-1:null,envMapSize:ae?Vt[0].width:null,aoMap:Ke,lightMap:He,bumpMap:un,normalMap:Be,displacementMap:Rn,emissiveMap:we,normalMapObjectSpace:Be&&x.normalMapType===dg,normalMapTangentSpace:Be&&x.normalMapType===Ph,packedNormalMap:Be&&x.normalMapType===Ph&&fT(x.normalMap.format),metalnessMap:yn,roughnessMap:en,anisotropy:fn,anisotropyMap:Kt,clearcoat:k,clearcoatMap:I,clearcoatNormalMap:M,clearcoatRoughnessMap:$,diffuseRoughness:Lt,diffuseRoughnessMap:ft,dispersion:Qt,retroreflection:he,iridescence:Et,iridescenceMap:at,iridescenceThicknessMap:yt,sheen:ze,sheenColorMap:St,sheenRoughnessMap:nt,specularMap:rt,specularColorMap:gt,specularIntensityMap:B,transmission:Wt,transmissionMap:ot,thicknessMap:it,gradientMap:At,opaque:x.transparent===!1&&x.blending===wo&&x.alphaToCoverage===!1,alphaMap:xt,alphaTest:wt,alphaHash:qt,combine:x.combine,mapUv:Xt&&d(x.map.channel),aoMapUv:Ke&&d(x.aoMap.channel),lightMapUv:He&&d(x.lightMap.channel),bumpMapUv:un&&d(x.bumpMap.channel),normalMapUv:Be&&d(x.normalMap.channel),displacementMapUv:Rn&&d(x.displacementMap.channel),emissiveMapUv:we&&d(x.emissiveMap.channel),metalnessMapUv:yn&&d(x.metalnessMap.channel),roughnessMapUv:en&&d(x.roughnessMap.channel),anisotropyMapUv:Kt&&d(x.anisotropyMap.channel),clearcoatMapUv:I&&d(x.clearcoatMap.channel),clearcoatNormalMapUv:M&&d(x.clearcoatNormalMap.channel),clearcoatRoughnessMapUv:$&&d(x.clearcoatRoughnessMap.channel),diffuseRoughnessMapUv:ft&&d(x.diffuseRoughnessMap.channel),iridescenceMapUv:at&&d(x.iridescenceMap.channel),iridescenceThicknessMapUv:yt&&d(x.iridescenceThicknessMap.channel),sheenColorMapUv:St&&d(x.sheenColorMap.channel),sheenRoughnessMapUv:nt&&d(x.sheenRoughnessMap.channel),specularMapUv:rt&&d(x.specularMap.channel),specularColorMapUv:gt&&d(x.specularColorMap.channel),specularIntensityMapUv:B&&d(x.specularIntensityMap.channel),transmissionMapUv:ot&&d(x.transmissionMap.channel),thicknessMapUv:it&&d(x.thicknessMap.channel),alphaMapUv:xt&&d(x.alphaMap.channel),vertexTangents:!!P.attributes.tangent&&(Be||fn),vertexNormals:!!P.attributes.normal,vertexColors:x.vertexColors,vertexAlphas:x.vertexColors===!0&&!!P.attributes.color&&P.attributes.color.itemSize===4,pointsUvs:L.isPoints===!0&&!!P.attributes.uv&&(Xt||xt),fog:!!O,useFog:x.fog===!0,fogExp2:!!O&&O.isFogExp2,flatShading:x.wireframe===!1&&(x.flatShading===!0||P.attributes.normal===void 0&&Be===!1&&(x.isMeshLambertMaterial||x.isMeshPhongMaterial||x.isMeshStandardMaterial||x.isMeshPhysicalMaterial)),sizeAttenuation:x.sizeAttenuation===!0,logarithmicDepthBuffer:u,reversedDepthBuffer:Tt,skinning:L.isSkinnedMesh===!0,hasPositionAttribute:P.attributes.position!==void 0,morphTargets:P.morphAttributes.position!==void 0,morphNormals:P.morphAttributes.normal!==void 0,morphColors:P.morphAttributes.color!==void 0,morphTargetsCount:st,morphTextureStride:pt,numSunLights:T.sun.length,numDirLights:T.directional.length,numPointLights:T.point.length,numSpotLights:T.spot.length,numSpotLightMaps:T.spotLightMap.length,numRectAreaLights:T.rectArea.length,numHemiLights:T.hemi.length,numSunLightShadows:T.sunShadowMap.length,numDirLightShadows:T.directionalShadowMap.length,numPointLightShadows:T.pointShadowMap.length,numSpotLightShadows:T.spotShadowMap.length,numSpotLightShadowsWithMaps:T.numSpotLightShadowsWithMaps,numLightProbes:T.numLightProbes,numLightProbeGrids:z.filter(It=>It.texture!==null).length,numClippingPlanes:r.numPlanes,numClipIntersection:r.numIntersection,dithering:x.dithering,shadowMapEnabled:i.shadowMap.enabled&&U.length>0,shadowMapType:i.shadowMap.type,toneMapping:ut,decodeVideoTexture:Xt&&x.map.isVideoTexture===!0&&Me.getTransfer(x.map.colorSpace)===Le,decodeVideoTextureEmissive:we&&x.emissiveMap.isVideoTexture===!0&&Me.getTransfer(x.emissiveMap.colorSpace)===Le,premultipliedAlpha:x.premultipliedAlpha,doubleSided:x.side===oi,flipSided:x.side===ei,useDepthPacking:x.depthPacking>=0,depthPacking:x.depthPacking||0,index0AttributeName:x.index0AttributeName,extensionClipCullDistance:ne&&x.extensions.clipCullDistance===!0&&e.has("WEBGL_clip_cull_distance"),extensionMultiDraw:(ne&&x.extensions.multiDraw===!0||ce)&&e.has("WEBGL_multi_draw"),rendererExtensionParallelShaderCompile:e.has("KHR_parallel_shader_compile"),customProgramCacheKey:x.customProgramCacheKey()};return ie.vertexUv1s=l.has(1),ie.vertexUv2s=l.has(2),ie.vertexUv3s=l.has(3),l.clear(),ie}function _(x){let T=[];if(x.shaderID?T.push(x.shaderID):(T.push(x.customVertexShaderID),T.push(x.customFragmentShaderID)),x.defines!==void 0)for(let U in x.defines)T.push(U),T.push(x.defines[U]);return x.isRawShaderMaterial===!1&&(g(T,x),m(T,x),T.push(i.outputColorSpace)),T.push(x.customProgramCacheKey),T.join()}function g(x,T){x.push(T.precision),x.push(T.outputColorSpace),x.push(T.envMapMode),x.push(T.envMapPMREM),x.push(T.envMapMaxLod),x.push(T.envMapSize),x.push(T.mapUv),x.push(T.alphaMapUv),x.push(T.lightMapUv),x.push(T.aoMapUv),x.push(T.bumpMapUv),x.push(T.normalMapUv),x.push(T.displacementMapUv),x.push(T.emissiveMapUv),x.push(T.metalnessMapUv),x.push(T.roughnessMapUv),x.push(T.anisotropyMapUv),x.push(T.clearcoatMapUv),x.push(T.clearcoatNormalMapUv),x.push(T.clearcoatRoughnessMapUv),x.push(T.diffuseRoughnessMapUv),x.push(T.iridescenceMapUv),x.push(T.iridescenceThicknessMapUv),x.push(T.sheenColorMapUv),x.push(T.sheenRoughnessMapUv),x.push(T.specularMapUv),x.push(T.specularColorMapUv),x.push(T.specularIntensityMapUv),x.push(T.transmissionMapUv),x.push(T.thicknessMapUv),x.push(T.combine),x.push(T.fogExp2),x.push(T.sizeAttenuation),x.push(T.morphTargetsCount),x.push(T.numSunLights),x.push(T.numDirLights),x.push(T.numPointLights),x.push(T.numSpotLights),x.push(T.numSpotLightMaps),x.push(T.numHemiLights),x.push(T.numRectAreaLights),x.push(T.numSunLightShadows),x.push(T.numDirLightShadows),x.push(T.numPointLightShadows),x.push(T.numSpotLightShadows),x.push(T.numSpotLightShadowsWithMaps),x.push(T.numLightProbes),x.push(T.numLightProbeGrids),x.push(T.shadowMapType),x.push(T.toneMapping),x.push(T.numClippingPlanes),x.push(T.numClipIntersection),x.push(T.depthPacking)}function m(x,T){o.disableAll(),T.instancing&&o.enable(0),T.instancingColor&&o.enable(1),T.instancingMorph&&o.enable(2),T.matcap&&o.enable(3),T.envMap&&o.enable(4),T.normalMapObjectSpace&&o.enable(5),T.normalMapTangentSpace&&o.enable(6),T.clearcoat&&o.enable(7),T.iridescence&&o.enable(8),T.alphaTest&&o.enable(9),T.vertexColors&&o.enable(10),T.vertexAlphas&&o.enable(11),T.vertexUv1s&&o.enable(12),T.vertexUv2s&&o.enable(13),T.vertexUv3s&&o.enable(14),T.vertexTangents&&o.enable(15),T.anisotropy&&o.enable(16),T.alphaHash&&o.enable(17),T.batching&&o.enable(18),T.dispersion&&o.enable(19),T.retroreflection&&o.enable(24),T.diffuseRoughness&&o.enable(25),T.batchingColor&&o.enable(20),T.gradientMap&&o.enable(21),T.packedNormalMap&&o.enable(22),T.vertexNormals&&o.enable(23),x.push(o.mask),o.disableAll(),T.fog&&o.enable(0),T.useFog&&o.enable(1),T.flatShading&&o.enable(2),T.logarithmicDepthBuffer&&o.enable(3),T.reversedDepthBuffer&&o.enable(4),T.skinning&&o.enable(5),T.morphTargets&&o.enable(6),T.morphNormals&&o.enable(7),T.morphColors&&o.enable(8),T.premultipliedAlpha&&o.enable(9),T.shadowMapEnabled&&o.enable(10),T.doubleSided&&o.enable(11),T.flipSided&&o.enable(12),T.useDepthPacking&&o.enable(13),T.dithering&&o.enable(14),T.transmission&&o.enable(15),T.sheen&&o.enable(16),T.opaque&&o.enable(17),T.pointsUvs&&o.enable(18),T.decodeVideoTexture&&o.enable(19),T.decodeVideoTextureEmissive&&o.enable(20),T.alphaToCoverage&&o.enable(21),T.numLightProbeGrids>0&&o.enable(22),T.hasPositionAttribute&&o.enable(23),x.push(o.mask)}function v(x){let T=h[x.type],U;if(T){let N=cs[T];U=Eg.clone(N.uniforms)}else U=x.uniforms;return U}function A(x,T){let U=f.get(T);return U!==void 0?++U.usedTimes:(U=new hT(i,T,x,s),c.push(U),f.set(T,U)),U}function S(x){if(--x.usedTimes===0){let T=c.indexOf(x);c[T]=c[c.length-1],c.pop(),f.delete(x.cacheKey),x.destroy()}}function R(x){a.remove(x)}function E(){a.dispose()}return{getParameters:p,getProgramCacheKey:_,getUniforms:v,acquireProgram:A,releaseProgram:S,releaseShaderCache:R,programs:c,dispose:E}}function pT(){let i=new WeakMap;function t(o){return i.has(o)}function e(o){let a=i.get(o);return a===void 0&&(a={},i.set(o,a)),a}function n(o){i.delete(o)}function s(o,a,l){i.get(o)[a]=l}function r(){i=new WeakMap}return{has:t,get:e,remove:n,update:s,dispose:r}}function mT(i,t){return i.groupOrder!==t.groupOrder?i.groupOrder-t.groupOrder:i.renderOrder!==t.renderOrder?i.renderOrder-t.renderOrder:i.material.id!==t.material.id?i.material.id-t.material.id:i.materialVariant!==t.materialVariant?i.materialVariant-t.materialVariant:i.z!==t.z?i.z-t.z:i.id-t.id}function qg(i,t){return i.groupOrder!==t.groupOrder?i.groupOrder-t.groupOrder:i.renderOrder!==t.renderOrder?i.renderOrder-t.renderOrder:i.z!==t.z?t.z-i.z:i.id-t.id}function $g(){let i=[],t=0,e=[],n=[],s=[];function r(){t=0,e.length=0,n.length=0,s.length=0}function o(h){let d=0;return h.isInstancedMesh&&(d+=2),h.isSkinnedMesh&&(d+=1),d}function a(h,d,p,_,g,m){let v=i[t];return v===void 0?(v={id:h.id,object:h,geometry:d,material:p,materialVariant:o(h),groupOrder:_,renderOrder:h.renderOrder,z:g,group:m},i[t]=v):(v.id=h.id,v.object=h,v.geometry=d,v.material=p,v.materialVariant=o(h),v.groupOrder=_,v.renderOrder=h.renderOrder,v.z=g,v.group=m),t++,v}function l(h,d,p,_,g,m,v){v.reversedDepth===!0&&(g=-g);let A=a(h,d,p,_,g,m);p.transmission>0?n.push(A):p.transparent===!0?s.push(A):e.push(A)}function c(h,d,p,_,g,m){let v=a(h,d,p,_,g,m);p.transmission>0?n.unshift(v):p.transparent===!0?s.unshift(v):e.unshift(v)}function f(h,d){e.length>1&&e.sort(h||mT),n.length>1&&n.sort(d||qg),s.length>1&&s.sort(d||qg)}function u(){for(let h=t,d=i.length;h<d;h++){let p=i[h];if(p.id===null)break;p.id=null,p.object=null,p.geometry=null,p.material=null,p.group=null}}return{opaque:e,transmissive:n,transparent:s,init:r,push:l,unshift:c,finish:u,sort:f}}function gT(){let i=new WeakMap;function t(n,s){let r=i.get(n),o;return r===void 0?(o=new $g,i.set(n,[o])):s>=r.length?(o=new $g,r.push(o)):o=r[s],o}function e(){i=new WeakMap}return{get:t,dispose:e}}function _T(){let i={};return{get:function(t){if(i[t.id]!==void 0)return i[t.id];let e;switch(t.type){case"SunLight":case"DirectionalLight":e={direction:new X,color:new ue};break;case"SpotLight":e={position:new X,direction:new X,color:new ue,distance:0,coneCos:0,penumbraCos:0,decay:0};break;case"PointLight":e={position:new X,color:new ue,distance:0,decay:0};break;case"HemisphereLight":e={direction:new X,skyColor:new ue,groundColor:new ue};break;case"RectAreaLight":e={color:new ue,position:new X,halfWidth:new X,halfHeight:new X};break}return i[t.id]=e,e}}}function xT(){let i={};return{get:function(t){if(i[t.id]!==void 0)return i[t.id];let e;switch(t.type){case"SunLight":case"DirectionalLight":e={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new Jt};break;case"SpotLight":e={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new Jt};break;case"PointLight":e={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new Jt,shadowCameraNear:1,shadowCameraFar:1e3};break}return i[t.id]=e,e}}}var yT=0;function vT(i,t){return(t.castShadow?2:0)-(i.castShadow?2:0)+(t.map?1:0)-(i.map?1:0)}function ST(i){let t=new _T,e=xT(),n={version:0,hash:{sunLength:-1,directionalLength:-1,pointLength:-1,spotLength:-1,rectAreaLength:-1,hemiLength:-1,numSunShadows:-1,numDirectionalShadows:-1,numPointShadows:-1,numSpotShadows:-1,numSpotMaps:-1,numLightProbes:-1},ambient:[0,0,0],probe:[],sun:[],sunShadow:[],sunShadowMap:[],sunShadowMatrix:[],sunShadowCascade:[],directional:[],directionalShadow:[],directionalShadowMap:[],directionalShadowMatrix:[],spot:[],spotLightMap:[],spotShadow:[],spotShadowMap:[],spotLightMatrix:[],rectArea:[],rectAreaLTC1:null,rectAreaLTC2:null,point:[],pointShadow:[],pointShadowMap:[],pointShadowMatrix:[],hemi:[],numSpotLightShadowsWithMaps:0,numLightProbes:0};for(let c=0;c<9;c++)n.probe.push(new X);let s=new X,r=new De,o=new De;function a(c){let f=0,u=0,h=0;for(let z=0;z<9;z++)n.probe[z].set(0,0,0);let d=0,p=0,_=0,g=0,m=0,v=0,A=0,S=0,R=0,E=0,x=0,T=0,U=0,N=0;c.sort(vT);for(let z=0,O=c.length;z<O;z++){let P=c[z],G=P.color,q=P.intensity,H=P.distance,ct=null;if(P.shadow&&P.shadow.map&&(P.shadow.map.texture.format===Qs?ct=P.shadow.map.texture:ct=P.shadow.map.depthTexture||P.shadow.map.texture),P.isAmbientLight)f+=G.r*q,u+=G.g*q,h+=G.b*q;else if(P.isLightProbe){for(let K=0;K<9;K++)n.probe[K].addScaledVector(P.sh.coefficients[K],q);N++}else if(P.isSunLight){let K=t.get(P);if(K.color.copy(P.color).multiplyScalar(P.intensity),P.castShadow){let et=P.shadow,st=e.get(P);st.shadowIntensity=et.intensity,st.shadowBias=et.bias,st.shadowNormalBias=et.normalBias,st.shadowRadius=et.radius,st.shadowMapSize.copy(et.mapSize).multiply(et.getFrameExtents()),n.sunShadow[p]=st,n.sunShadowMap[p]=ct;let pt=et.getViewportCount();for(let dt=0;dt<pt;dt++)n.sunShadowMatrix[_+dt]=et.getMatrix(dt),n.sunShadowCascade[_+dt]=et._cascadeData[dt];_+=pt,p++}n.sun[d]=K,d++}else if(P.isDirectionalLight){let K=t.get(P);if(K.color.copy(P.color).multiplyScalar(P.intensity),P.castShadow){let et=P.shadow,st=e.get(P);st.shadowIntensity=et.intensity,st.shadowBias=et.bias,st.shadowNormalBias=et.normalBias,st.shadowRadius=et.radius,st.shadowMapSize=et.mapSize,n.directionalShadow[g]=st,n.directionalShadowMap[g]=ct,n.directionalShadowMatrix[g]=P.shadow.matrix,R++}n.directional[g]=K,g++}else if(P.isSpotLight){let K=t.get(P);K.position.setFromMatrixPosition(P.matrixWorld),K.color.copy(G).multiplyScalar(q),K.distance=H,K.coneCos=Math.cos(P.angle),K.penumbraCos=Math.cos(P.angle*(1-P.penumbra)),K.decay=P.decay,n.spot[v]=K;let et=P.shadow;if(P.map&&(n.spotLightMap[T]=P.map,T++,et.updateMatrices(P),P.castShadow&&U++),n.spotLightMatrix[v]=et.matrix,P.castShadow){let st=e.get(P);st.shadowIntensity=et.intensity,st.shadowBias=et.bias,st.shadowNormalBias=et.normalBias,st.shadowRadius=et.radius,st.shadowMapSize=et.mapSize,n.spotShadow[v]=st,n.spotShadowMap[v]=ct,x++}v++}else if(P.isRectAreaLight){let K=t.get(P);K.color.copy(G).multiplyScalar(q),K.halfWidth.set(P.width*.5,0,0),K.halfHeight.set(0,P.height*.5,0),n.rectArea[A]=K,A++}else if(P.isPointLight){let K=t.get(P);if(K.color.copy(P.color).multiplyScalar(P.intensity),K.distance=P.distance,K.decay=P.decay,P.castShadow){let et=P.shadow,st=e.get(P);st.shadowIntensity=et.intensity,st.shadowBias=et.bias,st.shadowNormalBias=et.normalBias,st.shadowRadius=et.radius,st.shadowMapSize=et.mapSize,st.shadowCameraNear=et.camera.near,st.shadowCameraFar=et.camera.far,n.pointShadow[m]=st,n.pointShadowMap[m]=ct,n.pointShadowMatrix[m]=P.shadow.matrix,E++}n.point[m]=K,m++}else if(P.isHemisphereLight){let K=t.get(P);K.skyColor.copy(P.color).multiplyScalar(q),K.groundColor.copy(P.groundColor).multiplyScalar(q),n.hemi[S]=K,S++}}A>0&&(i.has("OES_texture_float_linear")===!0?(n.rectAreaLTC1=Ut.LTC_FLOAT_1,n.rectAreaLTC2=Ut.LTC_FLOAT_2):(n.rectAreaLTC1=Ut.LTC_HALF_1,n.rectAreaLTC2=Ut.LTC_HALF_2)),n.ambient[0]=f,n.ambient[1]=u,n.ambient[2]=h;let L=n.hash;(L.sunLength!==d||L.directionalLength!==g||L.pointLength!==m||L.spotLength!==v||L.rectAreaLength!==A||L.hemiLength!==S||L.numSunShadows!==p||L.numDirectionalShadows!==R||L.numPointShadows!==E||L.numSpotShadows!==x||L.numSpotMaps!==T||L.numLightProbes!==N)&&(n.sun.length=d,n.directional.length=g,n.spot.length=v,n.rectArea.length=A,n.point.length=m,n.hemi.length=S,n.sunShadow.length=p,n.sunShadowMap.length=p,n.sunShadowMatrix.length=_,n.sunShadowCascade.length=_,n.directionalShadow.length=R,n.directionalShadowMap.length=R,n.directionalShadowMatrix.length=R,n.pointShadow.length=E,n.pointShadowMap.length=E,n.pointShadowMatrix.length=E,n.spotShadow.length=x,n.spotShadowMap.length=x,n.spotLightMatrix.length=x+T-U,n.spotLightMap.length=T,n.numSpotLightShadowsWithMaps=U,n.numLightProbes=N,L.sunLength=d,L.directionalLength=g,L.pointLength=m,L.spotLength=v,L.rectAreaLength=A,L.hemiLength=S,L.numSunShadows=p,L.numDirectionalShadows=R,L.numPointShadows=E,L.numSpotShadows=x,L.numSpotMaps=T,L.numLightProbes=N,n.version=yT++)}function l(c,f){let u=0,h=0,d=0,p=0,_=0,g=0,m=f.matrixWorldInverse;for(let v=0,A=c.length;v<A;v++){let S=c[v];if(S.isSunLight){let R=n.sun[u];R.direction.setFromMatrixPosition(S.matrixWorld),R.direction.transformDirection(m),u++}else if(S.isDirectionalLight){let R=n.directional[h];R.direction.setFromMatrixPosition(S.matrixWorld),s.setFromMatrixPosition(S.target.matrixWorld),R.direction.sub(s),R.direction.transformDirection(m),h++}else if(S.isSpotLight){let R=n.spot[p];R.position.setFromMatrixPosition(S.matrixWorld),R.position.applyMatrix4(m),R.direction.setFromMatrixPosition(S.matrixWorld),s.setFromMatrixPosition(S.target.matrixWorld),R.direction.sub(s),R.direction.transformDirection(m),p++}else if(S.isRectAreaLight){let R=n.rectArea[_];R.position.setFromMatrixPosition(S.matrixWorld),R.position.applyMatrix4(m),o.identity(),r.copy(S.matrixWorld),r.premultiply(m),o.extractRotation(r),R.halfWidth.set(S.width*.5,0,0),R.halfHeight.set(0,S.height*.5,0),R.halfWidth.applyMatrix4(o),R.halfHeight.applyMatrix4(o),_++}else if(S.isPointLight){let R=n.point[d];R.position.setFromMatrixPosition(S.matrixWorld),R.position.applyMatrix4(m),d++}else if(S.isHemisphereLight){let R=n.hemi[g];R.direction.setFromMatrixPosition(S.matrixWorld),R.direction.transformDirection(m),g++}}}return{setup:a,setupView:l,state:n}}function Yg(i){let t=new ST(i),e=[],n=[],s=[];function r(u){f.camera=u,e.length=0,n.length=0,s.length=0}function o(u){u.isLightProbeGrid?s.push(u):e.push(u)}function a(u){n.push(u)}function l(){t.setup(e),s.sort((u,h)=>u.priority-h.priority||u.id-h.id)}function c(u){t.setupView(e,u)}let f={lightsArray:e,shadowsArray:n,lightProbeGridArray:s,camera:null,lights:t,transmissionRenderTarget:{},textureUnits:0};return{init:r,state:f,setupLights:l,setupLightsView:c,pushLight:o,pushShadow:a}}function MT(i){let t=new WeakMap;function e(s,r=0){let o=t.get(s),a;return o===void 0?(a=new Yg(i),t.set(s,[a])):r>=o.length?(a=new Yg(i),o.push(a)):a=o[r],a}function n(){t=new WeakMap}return{get:e,dispose:n}}var bT=`void main() {
	gl_Position = vec4( position, 1.0 );
}`,wT=`uniform sampler2D shadow_pass;
uniform vec2 resolution;
uniform float radius;
void main() {
	const float samples = float( VSM_SAMPLES );
	float mean = 0.0;
	float squared_mean = 0.0;
	float uvStride = samples <= 1.0 ? 0.0 : 2.0 / ( samples - 1.0 );
	float uvStart = samples <= 1.0 ? 0.0 : - 1.0;
	for ( float i = 0.0; i < samples; i ++ ) {
		float uvOffset = uvStart + i * uvStride;
		#ifdef HORIZONTAL_PASS
			vec2 distribution = texture2D( shadow_pass, ( gl_FragCoord.xy + vec2( uvOffset, 0.0 ) * radius ) / resolution ).rg;
			mean += distribution.x;
			squared_mean += distribution.y * distribution.y + distribution.x * distribution.x;
		#else
			float depth = texture2D( shadow_pass, ( gl_FragCoord.xy + vec2( 0.0, uvOffset ) * radius ) / resolution ).r;
			mean += depth;
			squared_mean += depth * depth;
		#endif
	}
	mean = mean / samples;
	squared_mean = squared_mean / samples;
	float std_dev = sqrt( max( 0.0, squared_mean - mean * mean ) );
	gl_FragColor = vec4( mean, std_dev, 0.0, 1.0 );
}`,TT=[new X(1,0,0),new X(-1,0,0),new X(0,1,0),new X(0,-1,0),new X(0,0,1),new X(0,0,-1)],ET=[new X(0,-1,0),new X(0,-1,0),new X(0,0,1),new X(0,0,-1),new X(0,-1,0),new X(0,-1,0)],Zg=new De,Xa=new X,Wf=new X;function AT(i,t,e){let n=new qs,s=new Jt,r=new Jt,o=new Qe,a=new Ic,l=new Lc,c={},f=e.maxTextureSize,u={[js]:ei,[ei]:js,[oi]:oi},h=new rs({defines:{VSM_SAMPLES:8},uniforms:{shadow_pass:{value:null},resolution:{value:new Jt},radius:{value:4}},vertexShader:bT,fragmentShader:wT}),d=h.clone();d.defines.HORIZONTAL_PASS=1;let p=new an;p.setAttribute("position",new Fi(new Float32Array([-1,-1,.5,3,-1,.5,-1,3,.5]),3));let _=new bn(p,h),g=this;this.enabled=!1,this.autoUpdate=!0,this.needsUpdate=!1,this.type=Oa;let m=this.type;this.render=function(E,x,T){if(g.enabled===!1||g.autoUpdate===!1&&g.needsUpdate===!1||E.length===0)return;this.type===Wm&&(jt("WebGLShadowMap: PCFSoftShadowMap has been removed. Using PCFShadowMap instead."),this.type=Oa);let U=i.getRenderTarget(),N=i.getActiveCubeFace(),L=i.getActiveMipmapLevel(),z=i.state;z.setBlending(xr),z.buffers.depth.getReversed()===!0?z.buffers.color.setClear(0,0,0,0):z.buffers.color.setClear(1,1,1,1),z.buffers.depth.setTest(!0),z.setScissorTest(!1);let O=m!==this.type;O&&x.traverse(function(P){P.material&&(Array.isArray(P.material)?P.material.forEach(G=>G.needsUpdate=!0):P.material.needsUpdate=!0)});for(let P=0,G=E.length;P<G;P++){let q=E[P],H=q.shadow;if(H===void 0){jt("WebGLShadowMap:",q,"has no shadow.");continue}if(H.autoUpdate===!1&&H.needsUpdate===!1)continue;s.copy(H.mapSize);let ct=H.getFrameExtents();s.multiply(ct),r.copy(H.mapSize),(s.x>f||s.y>f)&&(s.x>f&&(r.x=Math.floor(f/ct.x),s.x=r.x*ct.x,H.mapSize.x=r.x),s.y>f&&(r.y=Math.floor(f/ct.y),s.y=r.y*ct.y,H.mapSize.y=r.y));let K=i.state.buffers.depth.getReversed();if(H.camera._reversedDepth=K,H.map===null||O===!0){if(H.map!==null&&(H.map.depthTexture!==null&&(H.map.depthTexture.dispose(),H.map.depthTexture=null),H.map.dispose()),this.type===bo){if(q.isPointLight){jt("WebGLShadowMap: VSM shadow maps are not supported for PointLights. Use PCF or BasicShadowMap instead.");continue}H.map=new gi(s.x,s.y,{format:Qs,type:zi,minFilter:jn,magFilter:jn,generateMipmaps:!1}),H.map.texture.name=q.name+".shadowMap",H.map.depthTexture=new Ts(s.x,s.y,ki),H.map.depthTexture.name=q.name+".shadowMapDepth",H.map.depthTexture.format=bs,H.map.depthTexture.compareFunction=null,H.map.depthTexture.minFilter=Un,H.map.depthTexture.magFilter=Un}else q.isPointLight?(H.map=new $a(s.x),H.map.depthTexture=new ba(s.x,Bi)):(H.map=new gi(s.x,s.y),H.map.depthTexture=new Ts(s.x,s.y,Bi)),H.map.depthTexture.name=q.name+".shadowMap",H.map.depthTexture.format=bs,this.type===Oa?(H.map.depthTexture.compareFunction=K?Pf:Rf,H.map.depthTexture.minFilter=jn,H.map.depthTexture.magFilter=jn):(H.map.depthTexture.compareFunction=null,H.map.depthTexture.minFilter=Un,H.map.depthTexture.magFilter=Un);H.camera.updateProjectionMatrix()}H.map.isWebGLCubeRenderTarget!==!0&&(H.map.width!==s.x||H.map.height!==s.y)&&H.map.setSize(s.x,s.y);let et=H.map.isWebGLCubeRenderTarget?6:H.getViewportCount();q.isPointLight!==!0&&H.updateMatrices(q,T);let st=(H.camera.layers.mask&4294967294)!==0?H.camera.layers:T.layers;for(let pt=0;pt<et;pt++){let dt=H.getCamera(pt);if(q.isPointLight){let Q=H.camera,_t=H.matrix,vt=q.distance||Q.far;vt!==Q.far&&(Q.far=vt,Q.updateProjectionMatrix()),Xa.setFromMatrixPosition(q.matrixWorld),Q.position.copy(Xa),Wf.copy(Q.position),Wf.add(TT[pt]),Q.up.copy(ET[pt]),Q.lookAt(Wf),Q.updateMatrixWorld(),_t.makeTranslation(-Xa.x,-Xa.y,-Xa.z),Zg.multiplyMatrices(Q.projectionMatrix,Q.matrixWorldInverse),H._frustum.setFromProjectionMatrix(Zg,Q.coordinateSystem,Q.reversedDepth)}if(H.map.isWebGLCubeRenderTarget)i.setRenderTarget(H.map,pt),i.clear();else{pt===0&&(i.setRenderTarget(H.map),i.clear());let Q=H.getViewport(pt);o.set(r.x*Q.x,r.y*Q.y,r.x*Q.z,r.y*Q.w),z.viewport(o)}n=H.getFrustum(pt),S(x,T,dt,q,st,this.type)}H.isPointLightShadow!==!0&&this.type===bo&&v(H,T),H.needsUpdate=!1}m=this.type,g.needsUpdate=!1,i.setRenderTarget(U,N,L)};function v(E,x){let T=t.update(_);h.defines.VSM_SAMPLES!==E.blurSamples&&(h.defines.VSM_SAMPLES=E.blurSamples,d.defines.VSM_SAMPLES=E.blurSamples,h.needsUpdate=!0,d.needsUpdate=!0),E.mapPass===null?E.mapPass=new gi(s.x,s.y,{format:Qs,type:zi}):(E.mapPass.width!==E.map.width||E.mapPass.height!==E.map.height)&&E.mapPass.setSize(E.map.width,E.map.height),h.uniforms.shadow_pass.value=E.map.depthTexture,h.uniforms.resolution.value.set(E.map.width,E.map.height),h.uniforms.radius.value=E.radius,i.setRenderTarget(E.mapPass),i.clear(),i.renderBufferDirect(x,null,T,h,_,null),d.uniforms.shadow_pass.value=E.mapPass.texture,d.uniforms.resolution.value.set(E.map.width,E.map.height),d.uniforms.radius.value=E.radius,i.setRenderTarget(E.map),i.clear(),i.renderBufferDirect(x,null,T,d,_,null)}function A(E,x,T,U){let N=null,L=T.isPointLight===!0?E.customDistanceMaterial:E.customDepthMaterial;if(L!==void 0)N=L;else if(N=T.isPointLight===!0?l:a,i.localClippingEnabled&&x.clipShadows===!0&&Array.isArray(x.clippingPlanes)&&x.clippingPlanes.length!==0||x.displacementMap&&x.displacementScale!==0||x.alphaMap&&x.alphaTest>0||x.map&&x.alphaTest>0||x.alphaToCoverage===!0){let z=N.uuid,O=x.uuid,P=c[z];P===void 0&&(P={},c[z]=P);let G=P[O];G===void 0&&(G=N.clone(),P[O]=G,x.addEventListener("dispose",R)),N=G}if(N.visible=x.visible,N.wireframe=x.wireframe,U===bo?N.side=x.shadowSide!==null?x.shadowSide:x.side:N.side=x.shadowSide!==null?x.shadowSide:u[x.side],N.alphaMap=x.alphaMap,N.alphaTest=x.alphaToCoverage===!0?.5:x.alphaTest,N.map=x.map,N.clipShadows=x.clipShadows,N.clippingPlanes=x.clippingPlanes,N.clipIntersection=x.clipIntersection,N.displacementMap=x.displacementMap,N.displacementScale=x.displacementScale,N.displacementBias=x.displacementBias,N.wireframeLinewidth=x.wireframeLinewidth,N.linewidth=x.linewidth,T.isPointLight===!0&&N.isMeshDistanceMaterial===!0){let z=i.properties.get(N);z.light=T}return N}function S(E,x,T,U,N,L){if(E.visible===!1)return;if(E.layers.test(N)&&(E.isMesh||E.isLine||E.isPoints)&&(E.castShadow||E.receiveShadow&&L===bo)&&(!E.frustumCulled||E.intersectsFrustum(n))){E.modelViewMatrix.multiplyMatrices(T.matrixWorldInverse,E.matrixWorld);let P=t.update(E),G=E.material;if(Array.isArray(G)){let q=P.groups;for(let H=0,ct=q.length;H<ct;H++){let K=q[H],et=G[K.materialIndex];if(et&&et.visible){let st=A(E,et,U,L);E.onBeforeShadow(i,E,x,T,P,st,K),i.renderBufferDirect(T,null,P,st,E,K),E.onAfterShadow(i,E,x,T,P,st,K)}}}else if(G.visible){let q=A(E,G,U,L);E.onBeforeShadow(i,E,x,T,P,q,null),i.renderBufferDirect(T,null,P,q,E,null),E.onAfterShadow(i,E,x,T,P,q,null)}}let O=E.children;for(let P=0,G=O.length;P<G;P++)S(O[P],x,T,U,N,L)}function R(E){E.target.removeEventListener("dispose",R);for(let T in c){let U=c[T],N=E.target.uuid;N in U&&(U[N].dispose(),delete U[N])}}}function CT(i,t){function e(){let B=!1,ot=new Qe,it=null,At=new Qe(0,0,0,0);return{setMask:function(xt){it!==xt&&!B&&(i.colorMask(xt,xt,xt,xt),it=xt)},setLocked:function(xt){B=xt},setClear:function(xt,wt,qt,ne,ut){ut===!0&&(xt*=ne,wt*=ne,qt*=ne),ot.set(xt,wt,qt,ne),At.equals(ot)===!1&&(i.clearColor(xt,wt,qt,ne),At.copy(ot))},reset:function(){B=!1,it=null,At.set(-1,0,0,0)}}}function n(){let B=!1,ot=!1,it=null,At=null,xt=null;return{setReversed:function(wt){if(ot!==wt){let qt=t.get("EXT_clip_control");wt?qt.clipControlEXT(qt.LOWER_LEFT_EXT,qt.ZERO_TO_ONE_EXT):qt.clipControlEXT(qt.LOWER_LEFT_EXT,qt.NEGATIVE_ONE_TO_ONE_EXT),ot=wt;let ne=xt;xt=null,this.setClear(ne)}},getReversed:function(){return ot},setTest:function(wt){wt?Tt(i.DEPTH_TEST):Yt(i.DEPTH_TEST)},setMask:function(wt){it!==wt&&!B&&(i.depthMask(wt),it=wt)},setFunc:function(wt){if(ot&&(wt=bg[wt]),At!==wt){switch(wt){case fc:i.depthFunc(i.NEVER);break;case dc:i.depthFunc(i.ALWAYS);break;case pc:i.depthFunc(i.LESS);break;case uo:i.depthFunc(i.LEQUAL);break;case mc:i.depthFunc(i.EQUAL);break;case gc:i.depthFunc(i.GEQUAL);break;case _c:i.depthFunc(i.GREATER);break;case xc:i.depthFunc(i.NOTEQUAL);break;default:i.depthFunc(i.LEQUAL)}At=wt}},setLocked:function(wt){B=wt},setClear:function(wt){xt!==wt&&(xt=wt,ot&&(wt=1-wt),i.clearDepth(wt))},reset:function(){B=!1,it=null,At=null,xt=null,ot=!1}}}function s(){let B=!1,ot=null,it=null,At=null,xt=null,wt=null,qt=null,ne=null,ut=null;return{setTest:function(Vt){B||(Vt?Tt(i.STENCIL_TEST):Yt(i.STENCIL_TEST))},setMask:function(Vt){ot!==Vt&&!B&&(i.stencilMask(Vt),ot=Vt)},setFunc:function(Vt,ie,It){(it!==Vt||At!==ie||xt!==It)&&(i.stencilFunc(Vt,ie,It),it=Vt,At=ie,xt=It)},setOp:function(Vt,ie,It){(wt!==Vt||qt!==ie||ne!==It)&&(i.stencilOp(Vt,ie,It),wt=Vt,qt=ie,ne=It)},setLocked:function(Vt){B=Vt},setClear:function(Vt){ut!==Vt&&(i.clearStencil(Vt),ut=Vt)},reset:function(){B=!1,ot=null,it=null,At=null,xt=null,wt=null,qt=null,ne=null,ut=null}}}let r=new e,o=new n,a=new s,l={},c=new WeakMap,f={},u={},h={},d=new WeakMap,p=[],_=null,g=!1,m=null,v=null,A=null,S=null,R=null,E=null,x=null,T=new ue(0,0,0),U=0,N=!1,L=null,z=null,O=null,P=null,G=null,q=i.getParameter(i.MAX_COMBINED_TEXTURE_IMAGE_UNITS),H=!1,ct=0,K=i.getParameter(i.VERSION);K.indexOf("WebGL")!==-1?(ct=parseFloat(/^WebGL (\d)/.exec(K)[1]),H=ct>=1):K.indexOf("OpenGL ES")!==-1&&(ct=parseFloat(/^OpenGL ES (\d)/.exec(K)[1]),H=ct>=2);let et=null,st={},pt=i.getParameter(i.SCISSOR_BOX),dt=i.getParameter(i.VIEWPORT),Q=new Qe().fromArray(pt),_t=new Qe().fromArray(dt);function vt(B,ot,it,At){let xt=new Uint8Array(4),wt=i.createTexture();i.bindTexture(B,wt),i.texParameteri(B,i.TEXTURE_MIN_FILTER,i.NEAREST),i.texParameteri(B,i.TEXTURE_MAG_FILTER,i.NEAREST);for(let qt=0;qt<it;qt++)B===i.TEXTURE_3D||B===i.TEXTURE_2D_ARRAY?i.texImage3D(ot,0,i.RGBA,1,1,At,0,i.RGBA,i.UNSIGNED_BYTE,xt):i.texImage2D(ot+qt,0,i.RGBA,1,1,0,i.RGBA,i.UNSIGNED_BYTE,xt);return wt}let Pt={};Pt[i.TEXTURE_2D]=vt(i.TEXTURE_2D,i.TEXTURE_2D,1),Pt[i.TEXTURE_CUBE_MAP]=vt(i.TEXTURE_CUBE_MAP,i.TEXTURE_CUBE_MAP_POSITIVE_X,6),Pt[i.TEXTURE_2D_ARRAY]=vt(i.TEXTURE_2D_ARRAY,i.TEXTURE_2D_ARRAY,1,1),Pt[i.TEXTURE_3D]=vt(i.TEXTURE_3D,i.TEXTURE_3D,1,1),r.setClear(0,0,0,1),o.setClear(1),a.setClear(0),Tt(i.DEPTH_TEST),o.setFunc(uo),un(!1),Be(af),Tt(i.CULL_FACE),Ke(xr);function Tt(B){f[B]!==!0&&(i.enable(B),f[B]=!0)}function Yt(B){f[B]!==!1&&(i.disable(B),f[B]=!1)}function ce(B,ot){return h[B]!==ot?(i.bindFramebuffer(B,ot),h[B]=ot,B===i.DRAW_FRAMEBUFFER&&(h[i.FRAMEBUFFER]=ot),B===i.FRAMEBUFFER&&(h[i.DRAW_FRAMEBUFFER]=ot),!0):!1}function Xt(B,ot){let it=p,At=!1;if(B){it=d.get(ot),it===void 0&&(it=[],d.set(ot,it));let xt=B.textures;if(it.length!==xt.length||it[0]!==i.COLOR_ATTACHMENT0){for(let wt=0,qt=xt.length;wt<qt;wt++)it[wt]=i.COLOR_ATTACHMENT0+wt;it.length=xt.length,At=!0}}else it[0]!==i.BACK&&(it[0]=i.BACK,At=!0);At&&i.drawBuffers(it)}function ge(B){return _!==B?(i.useProgram(B),_=B,!0):!1}let de={[yr]:i.FUNC_ADD,[qm]:i.FUNC_SUBTRACT,[$m]:i.FUNC_REVERSE_SUBTRACT};de[Ym]=i.MIN,de[Zm]=i.MAX;let ae={[Jm]:i.ZERO,[Km]:i.ONE,[jm]:i.SRC_COLOR,[uf]:i.SRC_ALPHA,[sg]:i.SRC_ALPHA_SATURATE,[ng]:i.DST_COLOR,[tg]:i.DST_ALPHA,[Qm]:i.ONE_MINUS_SRC_COLOR,[ff]:i.ONE_MINUS_SRC_ALPHA,[ig]:i.ONE_MINUS_DST_COLOR,[eg]:i.ONE_MINUS_DST_ALPHA,[rg]:i.CONSTANT_COLOR,[og]:i.ONE_MINUS_CONSTANT_COLOR,[ag]:i.CONSTANT_ALPHA,[lg]:i.ONE_MINUS_CONSTANT_ALPHA};function Ke(B,ot,it,At,xt,wt,qt,ne,ut,Vt){if(B===xr){g===!0&&(Yt(i.BLEND),g=!1);return}if(g===!1&&(Tt(i.BLEND),g=!0),B!==Xm){if(B!==m||Vt!==N){if((v!==yr||R!==yr)&&(i.blendEquation(i.FUNC_ADD),v=yr,R=yr),Vt)switch(B){case wo:i.blendFuncSeparate(i.ONE,i.ONE_MINUS_SRC_ALPHA,i.ONE,i.ONE_MINUS_SRC_ALPHA);break;case lf:i.blendFunc(i.ONE,i.ONE);break;case cf:i.blendFuncSeparate(i.ZERO,i.ONE_MINUS_SRC_COLOR,i.ZERO,i.ONE);break;case hf:i.blendFuncSeparate(i.DST_COLOR,i.ONE_MINUS_SRC_ALPHA,i.ZERO,i.ONE);break;default:se("WebGLState: Invalid blending: ",B);break}else switch(B){case wo:i.blendFuncSeparate(i.SRC_ALPHA,i.ONE_MINUS_SRC_ALPHA,i.ONE,i.ONE_MINUS_SRC_ALPHA);break;case lf:i.blendFuncSeparate(i.SRC_ALPHA,i.ONE,i.ONE,i.ONE);break;case cf:se("WebGLState: SubtractiveBlending requires material.premultipliedAlpha = true");break;case hf:se("WebGLState: MultiplyBlending requires material.premultipliedAlpha = true");break;default:se("WebGLState: Invalid blending: ",B);break}A=null,S=null,E=null,x=null,T.set(0,0,0),U=0,m=B,N=Vt}return}xt=xt||ot,wt=wt||it,qt=qt||At,(ot!==v||xt!==R)&&(i.blendEquationSeparate(de[ot],de[xt]),v=ot,R=xt),(it!==A||At!==S||wt!==E||qt!==x)&&(i.blendFuncSeparate(ae[it],ae[At],ae[wt],ae[qt]),A=it,S=At,E=wt,x=qt),(ne.equals(T)===!1||ut!==U)&&(i.blendColor(ne.r,ne.g,ne.b,ut),T.copy(ne),U=ut),m=B,N=!1}function He(B,ot){B.side===oi?Yt(i.CULL_FACE):Tt(i.CULL_FACE);let it=B.side===ei;ot&&(it=!it),un(it),B.blending===wo&&B.transparent===!1?Ke(xr):Ke(B.blending,B.blendEquation,B.blendSrc,B.blendDst,B.blendEquationAlpha,B.blendSrcAlpha,B.blendDstAlpha,B.blendColor,B.blendAlpha,B.premultipliedAlpha),o.setFunc(B.depthFunc),o.setTest(B.depthTest),o.setMask(B.depthWrite),r.setMask(B.colorWrite);let At=B.stencilWrite;a.setTest(At),At&&(a.setMask(B.stencilWriteMask),a.setFunc(B.stencilFunc,B.stencilRef,B.stencilFuncMask),a.setOp(B.stencilFail,B.stencilZFail,B.stencilZPass)),we(B.polygonOffset,B.polygonOffsetFactor,B.polygonOffsetUnits),B.alphaToCoverage===!0?Tt(i.SAMPLE_ALPHA_TO_COVERAGE):Yt(i.SAMPLE_ALPHA_TO_COVERAGE)}function un(B){L!==B&&(B?i.frontFace(i.CW):i.frontFace(i.CCW),L=B)}function Be(B){B!==Gm?(Tt(i.CULL_FACE),B!==z&&(B===af?i.cullFace(i.BACK):B===Hm?i.cullFace(i.FRONT):i.cullFace(i.FRONT_AND_BACK))):Yt(i.CULL_FACE),z=B}function Rn(B){B!==O&&(H&&i.lineWidth(B),O=B)}function we(B,ot,it){B?(Tt(i.POLYGON_OFFSET_FILL),(P!==ot||G!==it)&&(P=ot,G=it,o.getReversed()&&(ot=-ot,it=-it),i.polygonOffset(ot,it))):Yt(i.POLYGON_OFFSET_FILL)}function yn(B){B?Tt(i.SCISSOR_TEST):Yt(i.SCISSOR_TEST)}function en(B){B===void 0&&(B=i.TEXTURE0+q-1),et!==B&&(i.activeTexture(B),et=B)}function fn(B,ot,it){it===void 0&&(et===null?it=i.TEXTURE0+q-1:it=et);let At=st[it];At===void 0&&(At={type:void 0,texture:void 0},st[it]=At),(At.type!==B||At.texture!==ot)&&(et!==it&&(i.activeTexture(it),et=it),i.bindTexture(B,ot||Pt[B]),At.type=B,At.texture=ot)}function k(){let B=st[et];B!==void 0&&B.type!==void 0&&(i.bindTexture(B.type,null),B.type=void 0,B.texture=void 0)}function Lt(){try{i.compressedTexImage2D(...arguments)}catch(B){se("WebGLState:",B)}}function Qt(){try{i.compressedTexImage3D(...arguments)}catch(B){se("WebGLState:",B)}}function he(){try{i.texSubImage2D(...arguments)}catch(B){se("WebGLState:",B)}}function Et(){try{i.texSubImage3D(...arguments)}catch(B){se("WebGLState:",B)}}function ze(){try{i.compressedTexSubImage2D(...arguments)}catch(B){se("WebGLState:",B)}}function Wt(){try{i.compressedTexSubImage3D(...arguments)}catch(B){se("WebGLState:",B)}}function Kt(){try{i.texStorage2D(...arguments)}catch(B){se("WebGLState:",B)}}function I(){try{i.texStorage3D(...arguments)}catch(B){se("WebGLState:",B)}}function M(){try{i.texImage2D(...arguments)}catch(B){se("WebGLState:",B)}}function $(){try{i.texImage3D(...arguments)}catch(B){se("WebGLState:",B)}}function ft(B){return u[B]!==void 0?u[B]:i.getParameter(B)}function at(B,ot){u[B]!==ot&&(i.pixelStorei(B,ot),u[B]=ot)}function yt(B){Q.equals(B)===!1&&(i.scissor(B.x,B.y,B.z,B.w),Q.copy(B))}function St(B){_t.equals(B)===!1&&(i.viewport(B.x,B.y,B.z,B.w),_t.copy(B))}function nt(B,ot){let it=c.get(ot);it===void 0&&(it=new WeakMap,c.set(ot,it));let At=it.get(B);At===void 0&&(At=i.getUniformBlockIndex(ot,B.name),i.uniformBlockBinding(ot,At,At),it.set(B,At))}function rt(B,ot,it){let xt=c.get(ot).get(B);l[xt]!==it&&(i.bindBufferBase(i.UNIFORM_BUFFER,xt,it),l[xt]=it)}function gt(){i.disable(i.BLEND),i.disable(i.CULL_FACE),i.disable(i.DEPTH_TEST),i.disable(i.POLYGON_OFFSET_FILL),i.disable(i.SCISSOR_TEST),i.disable(i.STENCIL_TEST),i.disable(i.SAMPLE_ALPHA_TO_COVERAGE),i.blendEquation(i.FUNC_ADD),i.blendFunc(i.ONE,i.ZERO),i.blendFuncSeparate(i.ONE,i.ZERO,i.ONE,i.ZERO),i.blendColor(0,0,0,0),i.colorMask(!0,!0,!0,!0),i.clearColor(0,0,0,0),i.depthMask(!0),i.depthFunc(i.LESS),o.setReversed(!1),i.clearDepth(1),i.stencilMask(4294967295),i.stencilFunc(i.ALWAYS,0,4294967295),i.stencilOp(i.KEEP,i.KEEP,i.KEEP),i.clearStencil(0),i.cullFace(i.BACK),i.frontFace(i.CCW),i.polygonOffset(0,0),i.activeTexture(i.TEXTURE0),i.bindFramebuffer(i.FRAMEBUFFER,null),i.bindFramebuffer(i.DRAW_FRAMEBUFFER,null),i.bindFramebuffer(i.READ_FRAMEBUFFER,null),i.useProgram(null),i.lineWidth(1),i.scissor(0,0,i.canvas.width,i.canvas.height),i.viewport(0,0,i.canvas.width,i.canvas.height),i.pixelStorei(i.PACK_ALIGNMENT,4),i.pixelStorei(i.UNPACK_ALIGNMENT,4),i.pixelStorei(i.UNPACK_FLIP_Y_WEBGL,!1),i.pixelStorei(i.UNPACK_PREMULTIPLY_ALPHA_WEBGL,!1),i.pixelStorei(i.UNPACK_COLORSPACE_CONVERSION_WEBGL,i.BROWSER_DEFAULT_WEBGL),i.pixelStorei(i.PACK_ROW_LENGTH,0),i.pixelStorei(i.PACK_SKIP_PIXELS,0),i.pixelStorei(i.PACK_SKIP_ROWS,0),i.pixelStorei(i.UNPACK_ROW_LENGTH,0),i.pixelStorei(i.UNPACK_IMAGE_HEIGHT,0),i.pixelStorei(i.UNPACK_SKIP_PIXELS,0),i.pixelStorei(i.UNPACK_SKIP_ROWS,0),i.pixelStorei(i.UNPACK_SKIP_IMAGES,0),f={},u={},et=null,st={},h={},l={},d=new WeakMap,p=[],_=null,g=!1,m=null,v=null,A=null,S=null,R=null,E=null,x=null,T=new ue(0,0,0),U=0,N=!1,L=null,z=null,O=null,P=null,G=null,Q.set(0,0,i.canvas.width,i.canvas.height),_t.set(0,0,i.canvas.width,i.canvas.height),r.reset(),o.reset(),a.reset()}return{buffers:{color:r,depth:o,stencil:a},enable:Tt,disable:Yt,bindFramebuffer:ce,drawBuffers:Xt,useProgram:ge,setBlending:Ke,setMaterial:He,setFlipSided:un,setCullFace:Be,setLineWidth:Rn,setPolygonOffset:we,setScissorTest:yn,activeTexture:en,bindTexture:fn,unbindTexture:k,compressedTexImage2D:Lt,compressedTexImage3D:Qt,texImage2D:M,texImage3D:$,pixelStorei:at,getParameter:ft,updateUBOMapping:nt,uniformBlockBinding:rt,texStorage2D:Kt,texStorage3D:I,texSubImage2D:he,texSubImage3D:Et,compressedTexSubImage2D:ze,compressedTexSubImage3D:Wt,scissor:yt,viewport:St,reset:gt}}function RT(i,t,e,n,s,r,o){let a=t.has("WEBGL_multisampled_render_to_texture")?t.get("WEBGL_multisampled_render_to_texture"):null,l=typeof navigator>"u"?!1:/OculusBrowser/g.test(navigator.userAgent),c=new Jt,f=new WeakMap,u=new Set,h,d=new WeakMap,p=new Set,_=new FinalizationRegistry(I=>p.delete(I)),g=!1;try{g=typeof OffscreenCanvas<"u"&&new OffscreenCanvas(1,1).getContext("2d")!==null}catch{}function m(I,M){return g?new OffscreenCanvas(I,M):fa("canvas")}function v(I,M,$){let ft=1,at=Kt(I);if((at.width>$||at.height>$)&&(ft=$/Math.max(at.width,at.height)),ft<1)if(typeof HTMLImageElement<"u"&&I instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&I instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&I instanceof ImageBitmap||typeof VideoFrame<"u"&&I instanceof VideoFrame){let yt=Math.floor(ft*at.width),St=Math.floor(ft*at.height);h===void 0&&(h=m(yt,St));let nt=M?m(yt,St):h;return nt.width=yt,nt.height=St,nt.getContext("2d").drawImage(I,0,0,yt,St),jt("WebGLRenderer: Texture has been resized from ("+at.width+"x"+at.height+") to ("+yt+"x"+St+")."),nt}else return"data"in I&&jt("WebGLRenderer: Image in DataTexture is too big ("+at.width+"x"+at.height+")."),I;return I}function A(I){return I.generateMipmaps}function S(I){i.generateMipmap(I)}function R(I){return I.isWebGLCubeRenderTarget?i.TEXTURE_CUBE_MAP:I.isWebGL3DRenderTarget?i.TEXTURE_3D:I.isWebGLArrayRenderTarget||I.isCompressedArrayTexture?i.TEXTURE_2D_ARRAY:i.TEXTURE_2D}function E(I,M,$,ft,at,yt=!1){if(I!==null){if(i[I]!==void 0)return i[I];jt("WebGLRenderer: Attempt to use non-existing WebGL internal format '"+I+"'")}let St;ft&&(St=t.get("EXT_texture_norm16"),St||jt("WebGLRenderer: Unable to use normalized textures without EXT_texture_norm16 extension"));let nt=M;if(M===i.RED&&($===i.FLOAT&&(nt=i.R32F),$===i.HALF_FLOAT&&(nt=i.R16F),$===i.UNSIGNED_BYTE&&(nt=i.R8),$===i.UNSIGNED_SHORT&&St&&(nt=St.R16_EXT),$===i.SHORT&&St&&(nt=St.R16_SNORM_EXT)),M===i.RED_INTEGER&&($===i.UNSIGNED_BYTE&&(nt=i.R8UI),$===i.UNSIGNED_SHORT&&(nt=i.R16UI),$===i.UNSIGNED_INT&&(nt=i.R32UI),$===i.BYTE&&(nt=i.R8I),$===i.SHORT&&(nt=i.R16I),$===i.INT&&(nt=i.R32I)),M===i.RG&&($===i.FLOAT&&(nt=i.RG32F),$===i.HALF_FLOAT&&(nt=i.RG16F),$===i.UNSIGNED_BYTE&&(nt=i.RG8),$===i.UNSIGNED_SHORT&&St&&(nt=St.RG16_EXT),$===i.SHORT&&St&&(nt=St.RG16_SNORM_EXT)),M===i.RG_INTEGER&&($===i.UNSIGNED_BYTE&&(nt=i.RG8UI),$===i.UNSIGNED_SHORT&&(nt=i.RG16UI),$===i.UNSIGNED_INT&&(nt=i.RG32UI),$===i.BYTE&&(nt=i.RG8I),$===i.SHORT&&(nt=i.RG16I),$===i.INT&&(nt=i.RG32I)),M===i.RGB_INTEGER&&($===i.UNSIGNED_BYTE&&(nt=i.RGB8UI),$===i.UNSIGNED_SHORT&&(nt=i.RGB16UI),$===i.UNSIGNED_INT&&(nt=i.RGB32UI),$===i.BYTE&&(nt=i.RGB8I),$===i.SHORT&&(nt=i.RGB16I),$===i.INT&&(nt=i.RGB32I)),M===i.RGBA_INTEGER&&($===i.UNSIGNED_BYTE&&(nt=i.RGBA8UI),$===i.UNSIGNED_SHORT&&(nt=i.RGBA16UI),$===i.UNSIGNED_INT&&(nt=i.RGBA32UI),$===i.BYTE&&(nt=i.RGBA8I),$===i.SHORT&&(nt=i.RGBA16I),$===i.INT&&(nt=i.RGBA32I)),M===i.RGB&&($===i.UNSIGNED_SHORT&&St&&(nt=St.RGB16_EXT),$===i.SHORT&&St&&(nt=St.RGB16_SNORM_EXT),$===i.UNSIGNED_INT_5_9_9_9_REV&&(nt=i.RGB9_E5),$===i.UNSIGNED_INT_10F_11F_11F_REV&&(nt=i.R11F_G11F_B10F)),M===i.RGBA){let rt=yt?ua:Me.getTransfer(at);$===i.FLOAT&&(nt=i.RGBA32F),$===i.HALF_FLOAT&&(nt=i.RGBA16F),$===i.UNSIGNED_BYTE&&(nt=rt===Le?i.SRGB8_ALPHA8:i.RGBA8),$===i.UNSIGNED_SHORT&&St&&(nt=St.RGBA16_EXT),$===i.SHORT&&St&&(nt=St.RGBA16_SNORM_EXT),$===i.UNSIGNED_SHORT_4_4_4_4&&(nt=i.RGBA4),$===i.UNSIGNED_SHORT_5_5_5_1&&(nt=i.RGB5_A1)}return(nt===i.R16F||nt===i.R32F||nt===i.RG16F||nt===i.RG32F||nt===i.RGBA16F||nt===i.RGBA32F)&&t.get("EXT_color_buffer_float"),nt}function x(I,M){let $;return I?M===null||M===Bi||M===Sr?$=i.DEPTH24_STENCIL8:M===ki?$=i.DEPTH32F_STENCIL8:M===Eo&&($=i.DEPTH24_STENCIL8,jt("DepthTexture: 16 bit depth attachment is not supported with stencil. Using 24-bit attachment.")):M===null||M===Bi||M===Sr?$=i.DEPTH_COMPONENT24:M===ki?$=i.DEPTH_COMPONENT32F:M===Eo&&($=i.DEPTH_COMPONENT16),$}function T(I,M){return A(I)===!0||I.isFramebufferTexture&&I.minFilter!==Un&&I.minFilter!==jn?Math.log2(Math.max(M.width,M.height))+1:I.mipmaps.length>0?I.mipmaps.length:I.isCompressedTexture&&Array.isArray(I.image)?M.mipmaps.length:1}function U(I){let M=new WeakRef(I);n.get(I).__ref=M,p.add(M),_.register(I,M,M)}function N(I){let M=n.get(I).__ref;M!==void 0&&(p.delete(M),_.unregister(M))}function L(I){O(I.target)}function z(I){P(I.target)}function O(I){I.removeEventListener("dispose",L),N(I),q(I),I.isVideoTexture&&f.delete(I),I.isHTMLTexture&&u.delete(I)}function P(I){I.removeEventListener("dispose",z),N(I),ct(I)}function G(){for(let I of p){let M=I.deref();M!==void 0&&(M.isRenderTarget===!0?P(M):O(M))}p.clear(),u.clear()}function q(I){let M=n.get(I);if(M.__webglInit===void 0)return;let $=I.source,ft=d.get($);if(ft){let at=ft[M.__cacheKey];at.usedTimes--,at.usedTimes===0&&H(I),Object.keys(ft).length===0&&d.delete($)}n.remove(I)}function H(I){let M=n.get(I);i.deleteTexture(M.__webglTexture);let $=I.source,ft=d.get($);delete ft[M.__cacheKey],o.memory.textures--}function ct(I){let M=n.get(I);M.__depthDisposeCallback&&M.__depthDisposeCallback();let $=I.depthTexture;if($&&$.renderTarget===I&&O($),I.isWebGLCubeRenderTarget)for(let at=0;at<6;at++){if(Array.isArray(M.__webglFramebuffer[at]))for(let yt=0;yt<M.__webglFramebuffer[at].length;yt++)i.deleteFramebuffer(M.__webglFramebuffer[at][yt]);else i.deleteFramebuffer(M.__webglFramebuffer[at]);M.__webglDepthbuffer&&i.deleteRenderbuffer(M.__webglDepthbuffer[at])}else{if(Array.isArray(M.__webglFramebuffer))for(let at=0;at<M.__webglFramebuffer.length;at++)i.deleteFramebuffer(M.__webglFramebuffer[at]);else i.deleteFramebuffer(M.__webglFramebuffer);if(M.__webglDepthbuffer&&i.deleteRenderbuffer(M.__webglDepthbuffer),M.__webglMultisampledFramebuffer&&i.deleteFramebuffer(M.__webglMultisampledFramebuffer),M.__webglColorRenderbuffer)for(let at=0;at<M.__webglColorRenderbuffer.length;at++)M.__webglColorRenderbuffer[at]&&i.deleteRenderbuffer(M.__webglColorRenderbuffer[at]);M.__webglDepthRenderbuffer&&i.deleteRenderbuffer(M.__webglDepthRenderbuffer)}let ft=I.textures;for(let at=0,yt=ft.length;at<yt;at++){let St=n.get(ft[at]);St.__webglTexture&&(i.deleteTexture(St.__webglTexture),o.memory.textures--),n.remove(ft[at])}n.remove(I)}let K=0;function et(){K=0}function st(){return K}function pt(I){K=I}function dt(){let I=K;return I>=s.maxTextures&&jt("WebGLTextures: Trying to use "+(I+1)+" texture units while this GPU supports only "+s.maxTextures),K+=1,I}function Q(I){let M=[];return M.push(I.wrapS),M.push(I.wrapT),M.push(I.wrapR||0),M.push(I.magFilter),M.push(I.minFilter),M.push(I.anisotropy),M.push(I.internalFormat),M.push(I.format),M.push(I.type),M.push(I.generateMipmaps),M.push(I.mipmapsAutoUpdate),M.push(I.premultiplyAlpha),M.push(I.flipY),M.push(I.unpackAlignment),M.push(I.colorSpace),M.join()}function _t(I,M){let $=n.get(I);if(I.isVideoTexture&&ze(I),I.isRenderTargetTexture===!1&&I.isExternalTexture!==!0&&I.version>0&&$.__version!==I.version){let ft=I.image;if(ft===null)jt("WebGLRenderer: Texture marked for update but no image data found.");else if(ft.complete===!1)jt("WebGLRenderer: Texture marked for update but image is incomplete");else{He($,I,M);return}}else I.isExternalTexture&&($.__webglTexture=I.sourceTexture?I.sourceTexture:null);e.bindTexture(i.TEXTURE_2D,$.__webglTexture,i.TEXTURE0+M)}function vt(I,M){let $=n.get(I);if(I.isRenderTargetTexture===!1&&I.version>0&&$.__version!==I.version){He($,I,M);return}else I.isExternalTexture&&($.__webglTexture=I.sourceTexture?I.sourceTexture:null);e.bindTexture(i.TEXTURE_2D_ARRAY,$.__webglTexture,i.TEXTURE0+M)}function Pt(I,M){let $=n.get(I);if(I.isRenderTargetTexture===!1&&I.version>0&&$.__version!==I.version){He($,I,M);return}e.bindTexture(i.TEXTURE_3D,$.__webglTexture,i.TEXTURE0+M)}function Tt(I,M){let $=n.get(I);if(I.version>0&&$.__version!==I.version){un($,I,M);return}e.bindTexture(i.TEXTURE_CUBE_MAP,$.__webglTexture,i.TEXTURE0+M)}let Yt={[yc]:i.REPEAT,[es]:i.CLAMP_TO_EDGE,[vc]:i.MIRRORED_REPEAT},ce={[Un]:i.NEAREST,[ug]:i.NEAREST_MIPMAP_NEAREST,[Ba]:i.NEAREST_MIPMAP_LINEAR,[jn]:i.LINEAR,[$c]:i.LINEAR_MIPMAP_NEAREST,[Es]:i.LINEAR_MIPMAP_LINEAR},Xt={[mg]:i.NEVER,[If]:i.ALWAYS,[gg]:i.LESS,[Rf]:i.LEQUAL,[_g]:i.EQUAL,[Pf]:i.GEQUAL,[xg]:i.GREATER,[yg]:i.NOTEQUAL};function ge(I,M){if(M.type===ki&&t.has("OES_texture_float_linear")===!1&&(M.magFilter===jn||M.magFilter===$c||M.magFilter===Ba||M.magFilter===Es||M.minFilter===jn||M.minFilter===$c||M.minFilter===Ba||M.minFilter===Es)&&jt("WebGLRenderer: Unable to use linear filtering with floating point textures. OES_texture_float_linear not supported on this device."),i.texParameteri(I,i.TEXTURE_WRAP_S,Yt[M.wrapS]),i.texParameteri(I,i.TEXTURE_WRAP_T,Yt[M.wrapT]),(I===i.TEXTURE_3D||I===i.TEXTURE_2D_ARRAY)&&i.texParameteri(I,i.TEXTURE_WRAP_R,Yt[M.wrapR]),i.texParameteri(I,i.TEXTURE_MAG_FILTER,ce[M.magFilter]),i.texParameteri(I,i.TEXTURE_MIN_FILTER,ce[M.minFilter]),M.compareFunction&&(i.texParameteri(I,i.TEXTURE_COMPARE_MODE,i.COMPARE_REF_TO_TEXTURE),i.texParameteri(I,i.TEXTURE_COMPARE_FUNC,Xt[M.compareFunction])),t.has("EXT_texture_filter_anisotropic")===!0){if(M.magFilter===Un||M.minFilter!==Ba&&M.minFilter!==Es||M.type===ki&&t.has("OES_texture_float_linear")===!1)return;if(M.anisotropy>1||n.get(M).__currentAnisotropy){let $=t.get("EXT_texture_filter_anisotropic");i.texParameterf(I,$.TEXTURE_MAX_ANISOTROPY_EXT,Math.min(M.anisotropy,s.getMaxAnisotropy())),n.get(M).__currentAnisotropy=M.anisotropy}}}function de(I,M){let $=!1;I.__webglInit===void 0&&(I.__webglInit=!0,M.addEventListener("dispose",L),U(M));let ft=M.source,at=d.get(ft);at===void 0&&(at={},d.set(ft,at));let yt=Q(M);if(yt!==I.__cacheKey){at[yt]===void 0&&(at[yt]={texture:i.createTexture(),usedTimes:0},o.memory.textures++,$=!0),at[yt].usedTimes++;let St=at[I.__cacheKey];St!==void 0&&(at[I.__cacheKey].usedTimes--,St.usedTimes===0&&H(M)),I.__cacheKey=yt,I.__webglTexture=at[yt].texture}return $}function ae(I,M,$){return Math.floor(Math.floor(I/$)/M)}function Ke(I,M,$,ft){let yt=I.updateRanges;if(yt.length===0)e.texSubImage2D(i.TEXTURE_2D,0,0,0,M.width,M.height,$,ft,M.data);else{yt.sort((B,ot)=>B.start-ot.start);let St=0;for(let B=1;B<yt.length;B++){let ot=yt[St],it=yt[B],At=ot.start+ot.count,xt=ae(it.start,M.width,4),wt=ae(ot.start,M.width,4);it.start<=At+1&&xt===wt&&ae(it.start+it.count-1,M.width,4)===xt?ot.count=Math.max(ot.count,it.start+it.count-ot.start):(++St,yt[St]=it)}yt.length=St+1;let nt=e.getParameter(i.UNPACK_ROW_LENGTH),rt=e.getParameter(i.UNPACK_SKIP_PIXELS),gt=e.getParameter(i.UNPACK_SKIP_ROWS);e.pixelStorei(i.UNPACK_ROW_LENGTH,M.width);for(let B=0,ot=yt.length;B<ot;B++){let it=yt[B],At=Math.floor(it.start/4),xt=Math.ceil(it.count/4),wt=At%M.width,qt=Math.floor(At/M.width),ne=xt,ut=1;e.pixelStorei(i.UNPACK_SKIP_PIXELS,wt),e.pixelStorei(i.UNPACK_SKIP_ROWS,qt),e.texSubImage2D(i.TEXTURE_2D,0,wt,qt,ne,ut,$,ft,M.data)}I.clearUpdateRanges(),e.pixelStorei(i.UNPACK_ROW_LENGTH,nt),e.pixelStorei(i.UNPACK_SKIP_PIXELS,rt),e.pixelStorei(i.UNPACK_SKIP_ROWS,gt)}}function He(I,M,$){let ft=i.TEXTURE_2D;(M.isDataArrayTexture||M.isCompressedArrayTexture)&&(ft=i.TEXTURE_2D_ARRAY),M.isData3DTexture&&(ft=i.TEXTURE_3D);let at=de(I,M),yt=M.source;e.bindTexture(ft,I.__webglTexture,i.TEXTURE0+$);let St=n.get(yt);if(yt.version!==St.__version||at===!0){if(e.activeTexture(i.TEXTURE0+$),(typeof ImageBitmap<"u"&&M.image instanceof ImageBitmap)===!1){let ut=Me.getPrimaries(Me.workingColorSpace),Vt=M.colorSpace===Cs?null:Me.getPrimaries(M.colorSpace),ie=M.colorSpace===Cs||ut===Vt?i.NONE:i.BROWSER_DEFAULT_WEBGL;e.pixelStorei(i.UNPACK_FLIP_Y_WEBGL,M.flipY),e.pixelStorei(i.UNPACK_PREMULTIPLY_ALPHA_WEBGL,M.premultiplyAlpha),e.pixelStorei(i.UNPACK_COLORSPACE_CONVERSION_WEBGL,ie)}e.pixelStorei(i.UNPACK_ALIGNMENT,M.unpackAlignment);let rt=v(M.image,!1,s.maxTextureSize);rt=Wt(M,rt);let gt=r.convert(M.format,M.colorSpace),B=r.convert(M.type),ot=E(M.internalFormat,gt,B,M.normalized,M.colorSpace,M.isVideoTexture);ge(ft,M);let it,At=M.mipmaps,xt=M.isVideoTexture!==!0,wt=St.__version===void 0||at===!0,qt=yt.dataReady,ne=T(M,rt);if(M.isDepthTexture)ot=x(M.format===As,M.type),wt&&(xt?e.texStorage2D(i.TEXTURE_2D,1,ot,rt.width,rt.height):e.texImage2D(i.TEXTURE_2D,0,ot,rt.width,rt.height,0,gt,B,null));else if(M.isDataTexture)if(At.length>0){xt&&wt&&e.texStorage2D(i.TEXTURE_2D,ne,ot,At[0].width,At[0].height);for(let ut=0,Vt=At.length;ut<Vt;ut++)it=At[ut],xt?qt&&e.texSubImage2D(i.TEXTURE_2D,ut,0,0,it.width,it.height,gt,B,it.data):e.texImage2D(i.TEXTURE_2D,ut,ot,it.width,it.height,0,gt,B,it.data);M.generateMipmaps=!1}else xt?(wt&&e.texStorage2D(i.TEXTURE_2D,ne,ot,rt.width,rt.height),qt&&Ke(M,rt,gt,B)):e.texImage2D(i.TEXTURE_2D,0,ot,rt.width,rt.height,0,gt,B,rt.data);else if(M.isCompressedTexture)if(M.isCompressedArrayTexture){xt&&wt&&e.texStorage3D(i.TEXTURE_2D_ARRAY,ne,ot,At[0].width,At[0].height,rt.depth);for(let ut=0,Vt=At.length;ut<Vt;ut++)if(it=At[ut],M.format!==Vi)if(gt!==null)if(xt){if(qt)if(M.layerUpdates.size>0){let ie=Gf(it.width,it.height,M.format,M.type);for(let It of M.layerUpdates){let fe=it.data.subarray(It*ie/it.data.BYTES_PER_ELEMENT,(It+1)*ie/it.data.BYTES_PER_ELEMENT);e.compressedTexSubImage3D(i.TEXTURE_2D_ARRAY,ut,0,0,It,it.width,it.height,1,gt,fe)}}else e.compressedTexSubImage3D(i.TEXTURE_2D_ARRAY,ut,0,0,0,it.width,it.height,rt.depth,gt,it.data)}else e.compressedTexImage3D(i.TEXTURE_2D_ARRAY,ut,ot,it.width,it.height,rt.depth,0,it.data,0,0);else jt("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()");else xt?qt&&e.texSubImage3D(i.TEXTURE_2D_ARRAY,ut,0,0,0,it.width,it.height,rt.depth,gt,B,it.data):e.texImage3D(i.TEXTURE_2D_ARRAY,ut,ot,it.width,it.height,rt.depth,0,gt,B,it.data);M.layerUpdates.size>0&&M.clearLayerUpdates()}else{xt&&wt&&e.texStorage2D(i.TEXTURE_2D,ne,ot,At[0].width,At[0].height);for(let ut=0,Vt=At.length;ut<Vt;ut++)it=At[ut],M.format!==Vi?gt!==null?xt?qt&&e.compressedTexSubImage2D(i.TEXTURE_2D,ut,0,0,it.width,it.height,gt,it.data):e.compressedTexImage2D(i.TEXTURE_2D,ut,ot,it.width,it.height,0,it.data):jt("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()"):xt?qt&&e.texSubImage2D(i.TEXTURE_2D,ut,0,0,it.width,it.height,gt,B,it.data):e.texImage2D(i.TEXTURE_2D,ut,ot,it.width,it.height,0,gt,B,it.data)}else if(M.isDataArrayTexture)if(xt){if(wt&&e.texStorage3D(i.TEXTURE_2D_ARRAY,ne,ot,rt.width,rt.height,rt.depth),qt)if(M.layerUpdates.size>0){let ut=Gf(rt.width,rt.height,M.format,M.type);for(let Vt of M.layerUpdates){let ie=rt.data.subarray(Vt*ut/rt.data.BYTES_PER_ELEMENT,(Vt+1)*ut/rt.data.BYTES_PER_ELEMENT);e.texSubImage3D(i.TEXTURE_2D_ARRAY,0,0,0,Vt,rt.width,rt.height,1,gt,B,ie)}M.clearLayerUpdates()}else e.texSubImage3D(i.TEXTURE_2D_ARRAY,0,0,0,0,rt.width,rt.height,rt.depth,gt,B,rt.data)}else e.texImage3D(i.TEXTURE_2D_ARRAY,0,ot,rt.width,rt.height,rt.depth,0,gt,B,rt.data);else if(M.isData3DTexture)xt?(wt&&e.texStorage3D(i.TEXTURE_3D,ne,ot,rt.width,rt.height,rt.depth),qt&&e.texSubImage3D(i.TEXTURE_3D,0,0,0,0,rt.width,rt.height,rt.depth,gt,B,rt.data)):e.texImage3D(i.TEXTURE_3D,0,ot,rt.width,rt.height,rt.depth,0,gt,B,rt.data);else if(M.isFramebufferTexture){if(wt)if(xt)e.texStorage2D(i.TEXTURE_2D,ne,ot,rt.width,rt.height);else{let ut=rt.width,Vt=rt.height;for(let ie=0;ie<ne;ie++)e.texImage2D(i.TEXTURE_2D,ie,ot,ut,Vt,0,gt,B,null),ut>>=1,Vt>>=1}}else if(M.isHTMLTexture){if("texElementImage2D"in i){let ut=i.canvas;if(ut.hasAttribute("layoutsubtree")||ut.setAttribute("layoutsubtree","true"),rt.parentNode!==ut){ut.appendChild(rt),u.add(M),ut.onpaint=Vt=>{let ie=Vt.changedElements;for(let It of u)ie.includes(It.image)&&(It.needsUpdate=!0)},ut.requestPaint();return}if(i.texElementImage2D.length===3)i.texElementImage2D(i.TEXTURE_2D,i.RGBA8,rt);else{let ie=i.RGBA,It=i.RGBA,fe=i.UNSIGNED_BYTE;i.texElementImage2D(i.TEXTURE_2D,0,ie,It,fe,rt)}i.texParameteri(i.TEXTURE_2D,i.TEXTURE_MIN_FILTER,i.LINEAR),i.texParameteri(i.TEXTURE_2D,i.TEXTURE_WRAP_S,i.CLAMP_TO_EDGE),i.texParameteri(i.TEXTURE_2D,i.TEXTURE_WRAP_T,i.CLAMP_TO_EDGE)}}else if(At.length>0){if(xt&&wt){let ut=Kt(At[0]);e.texStorage2D(i.TEXTURE_2D,ne,ot,ut.width,ut.height)}for(let ut=0,Vt=At.length;ut<Vt;ut++)it=At[ut],xt?qt&&e.texSubImage2D(i.TEXTURE_2D,ut,0,0,gt,B,it):e.texImage2D(i.TEXTURE_2D,ut,ot,gt,B,it);M.generateMipmaps=!1}else if(xt){if(wt){let ut=Kt(rt);e.texStorage2D(i.TEXTURE_2D,ne,ot,ut.width,ut.height)}qt&&e.texSubImage2D(i.TEXTURE_2D,0,0,0,gt,B,rt)}else e.texImage2D(i.TEXTURE_2D,0,ot,gt,B,rt);A(M)&&M.mipmapsAutoUpdate===!0&&S(ft),St.__version=yt.version,M.onUpdate&&M.onUpdate(M)}I.__version=M.version}function un(I,M,$){if(M.image.length!==6)return;let ft=de(I,M),at=M.source;e.bindTexture(i.TEXTURE_CUBE_MAP,I.__webglTexture,i.TEXTURE0+$);let yt=n.get(at);if(at.version!==yt.__version||ft===!0){e.activeTexture(i.TEXTURE0+$);let St=Me.getPrimaries(Me.workingColorSpace),nt=M.colorSpace===Cs?null:Me.getPrimaries(M.colorSpace),rt=M.colorSpace===Cs||St===nt?i.NONE:i.BROWSER_DEFAULT_WEBGL;e.pixelStorei(i.UNPACK_FLIP_Y_WEBGL,M.flipY),e.pixelStorei(i.UNPACK_PREMULTIPLY_ALPHA_WEBGL,M.premultiplyAlpha),e.pixelStorei(i.UNPACK_ALIGNMENT,M.unpackAlignment),e.pixelStorei(i.UNPACK_COLORSPACE_CONVERSION_WEBGL,rt);let gt=M.isCompressedTexture||M.image[0].isCompressedTexture,B=M.image[0]&&M.image[0].isDataTexture,ot=[];for(let It=0;It<6;It++)!gt&&!B?ot[It]=v(M.image[It],!0,s.maxCubemapSize):ot[It]=B?M.image[It].image:M.image[It],ot[It]=Wt(M,ot[It]);let it=ot[0],At=r.convert(M.format,M.colorSpace),xt=r.convert(M.type),wt=E(M.internalFormat,At,xt,M.normalized,M.colorSpace),qt=M.isVideoTexture!==!0,ne=yt.__version===void 0||ft===!0,ut=at.dataReady,Vt=T(M,it);ge(i.TEXTURE_CUBE_MAP,M);let ie;if(M.isDepthTexture){if(wt=x(M.format===As,M.type),ne)if(qt)e.texStorage2D(i.TEXTURE_CUBE_MAP,1,wt,it.width,it.height);else for(let It=0;It<6;It++)e.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+It,0,wt,it.width,it.height,0,At,xt,null)}else if(gt){qt&&ne&&e.texStorage2D(i.TEXTURE_CUBE_MAP,Vt,wt,it.width,it.height);for(let It=0;It<6;It++){ie=ot[It].mipmaps;for(let fe=0;fe<ie.length;fe++){let Xe=ie[fe];M.format!==Vi?At!==null?qt?ut&&e.compressedTexSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+It,fe,0,0,Xe.width,Xe.height,At,Xe.data):e.compressedTexImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+It,fe,wt,Xe.width,Xe.height,0,Xe.data):jt("WebGLRenderer: Attempt to load unsupported compressed texture format in .setTextureCube()"):qt?ut&&e.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+It,fe,0,0,Xe.width,Xe.height,At,xt,Xe.data):e.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+It,fe,wt,Xe.width,Xe.height,0,At,xt,Xe.data)}}}else{if(ie=M.mipmaps,qt&&ne){ie.length>0&&Vt++;let It=Kt(ot[0]);e.texStorage2D(i.TEXTURE_CUBE_MAP,Vt,wt,It.width,It.height)}for(let It=0;It<6;It++)if(B){qt?ut&&e.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+It,0,0,0,ot[It].width,ot[It].height,At,xt,ot[It].data):e.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+It,0,wt,ot[It].width,ot[It].height,0,At,xt,ot[It].data);for(let fe=0;fe<ie.length;fe++){let Wn=ie[fe].image[It].image;qt?ut&&e.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+It,fe+1,0,0,Wn.width,Wn.height,At,xt,Wn.data):e.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+It,fe+1,wt,Wn.width,Wn.height,0,At,xt,Wn.data)}}else{qt?ut&&e.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+It,0,0,0,At,xt,ot[It]):e.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+It,0,wt,At,xt,ot[It]);for(let fe=0;fe<ie.length;fe++){let Xe=ie[fe];qt?ut&&e.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+It,fe+1,0,0,At,xt,Xe.image[It]):e.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+It,fe+1,wt,At,xt,Xe.image[It])}}}A(M)&&M.mipmapsAutoUpdate===!0&&S(i.TEXTURE_CUBE_MAP),yt.__version=at.version,M.onUpdate&&M.onUpdate(M)}I.__version=M.version}function Be(I,M,$,ft,at,yt){let St=r.convert($.format,$.colorSpace),nt=r.convert($.type),rt=E($.internalFormat,St,nt,$.normalized,$.colorSpace),gt=n.get(M),B=n.get($);if(B.__renderTarget=M,!gt.__hasExternalTextures){let ot=Math.max(1,M.width>>yt),it=Math.max(1,M.height>>yt);at===i.TEXTURE_3D||at===i.TEXTURE_2D_ARRAY?e.texImage3D(at,yt,rt,ot,it,M.depth,0,St,nt,null):e.texImage2D(at,yt,rt,ot,it,0,St,nt,null)}e.bindFramebuffer(i.FRAMEBUFFER,I),Et(M)?a.framebufferTexture2DMultisampleEXT(i.FRAMEBUFFER,ft,at,B.__webglTexture,0,he(M)):(at===i.TEXTURE_2D||at>=i.TEXTURE_CUBE_MAP_POSITIVE_X&&at<=i.TEXTURE_CUBE_MAP_NEGATIVE_Z)&&i.framebufferTexture2D(i.FRAMEBUFFER,ft,at,B.__webglTexture,yt),e.bindFramebuffer(i.FRAMEBUFFER,null)}function Rn(I,M,$){if(i.bindRenderbuffer(i.RENDERBUFFER,I),M.depthBuffer){let ft=M.depthTexture,at=ft&&ft.isDepthTexture?ft.type:null,yt=x(M.stencilBuffer,at),St=M.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT;Et(M)?a.renderbufferStorageMultisampleEXT(i.RENDERBUFFER,he(M),yt,M.width,M.height):$?i.renderbufferStorageMultisample(i.RENDERBUFFER,he(M),yt,M.width,M.height):i.renderbufferStorage(i.RENDERBUFFER,yt,M.width,M.height),i.framebufferRenderbuffer(i.FRAMEBUFFER,St,i.RENDERBUFFER,I)}else{let ft=M.textures;for(let at=0;at<ft.length;at++){let yt=ft[at],St=r.convert(yt.format,yt.colorSpace),nt=r.convert(yt.type),rt=E(yt.internalFormat,St,nt,yt.normalized,yt.colorSpace);Et(M)?a.renderbufferStorageMultisampleEXT(i.RENDERBUFFER,he(M),rt,M.width,M.height):$?i.renderbufferStorageMultisample(i.RENDERBUFFER,he(M),rt,M.width,M.height):i.renderbufferStorage(i.RENDERBUFFER,rt,M.width,M.height)}}i.bindRenderbuffer(i.RENDERBUFFER,null)}function we(I,M,$){let ft=M.isWebGLCubeRenderTarget===!0;if(e.bindFramebuffer(i.FRAMEBUFFER,I),!(M.depthTexture&&M.depthTexture.isDepthTexture))throw new Error("THREE.WebGLTextures: renderTarget.depthTexture must be an instance of THREE.DepthTexture.");let at=n.get(M.depthTexture);at.__renderTarget=M;let yt=ft?M.depthTexture.image[0]:M.depthTexture.image;(!at.__webglTexture||yt.width!==M.width||yt.height!==M.height)&&(yt.width=M.width,yt.height=M.height,M.depthTexture.needsUpdate=!0),ft?Tt(M.depthTexture,0):_t(M.depthTexture,0);let St=at.__webglTexture,nt=he(M),rt=ft?i.TEXTURE_CUBE_MAP_POSITIVE_X+$:i.TEXTURE_2D,gt=M.depthTexture.format===As?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT;if(M.depthTexture.format===bs)Et(M)?a.framebufferTexture2DMultisampleEXT(i.FRAMEBUFFER,gt,rt,St,0,nt):i.framebufferTexture2D(i.FRAMEBUFFER,gt,rt,St,0);else if(M.depthTexture.format===As)Et(M)?a.framebufferTexture2DMultisampleEXT(i.FRAMEBUFFER,gt,rt,St,0,nt):i.framebufferTexture2D(i.FRAMEBUFFER,gt,rt,St,0);else throw new Error("THREE.WebGLTextures: Unknown depthTexture format.")}function yn(I){let M=n.get(I),$=I.isWebGLCubeRenderTarget===!0;if(M.__boundDepthTexture!==I.depthTexture){let ft=I.depthTexture;if(M.__depthDisposeCallback&&M.__depthDisposeCallback(),ft){let at=()=>{delete M.__boundDepthTexture,delete M.__depthDisposeCallback,ft.removeEventListener("dispose",at)};ft.addEventListener("dispose",at),M.__depthDisposeCallback=at}M.__boundDepthTexture=ft}if(I.depthTexture&&!M.__autoAllocateDepthBuffer)if($)for(let ft=0;ft<6;ft++)we(M.__webglFramebuffer[ft],I,ft);else I.texture.mipmaps.length>0?we(M.__webglFramebuffer[0],I,0):we(M.__webglFramebuffer,I,0);else if($){M.__webglDepthbuffer=[];for(let ft=0;ft<6;ft++)if(e.bindFramebuffer(i.FRAMEBUFFER,M.__webglFramebuffer[ft]),M.__webglDepthbuffer[ft]===void 0)M.__webglDepthbuffer[ft]=i.createRenderbuffer(),Rn(M.__webglDepthbuffer[ft],I,!1);else{let at=I.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT,yt=M.__webglDepthbuffer[ft];i.bindRenderbuffer(i.RENDERBUFFER,yt),i.framebufferRenderbuffer(i.FRAMEBUFFER,at,i.RENDERBUFFER,yt)}}else if(I.texture.mipmaps.length>0?e.bindFramebuffer(i.FRAMEBUFFER,M.__webglFramebuffer[0]):e.bindFramebuffer(i.FRAMEBUFFER,M.__webglFramebuffer),M.__webglDepthbuffer===void 0)M.__webglDepthbuffer=i.createRenderbuffer(),Rn(M.__webglDepthbuffer,I,!1);else{let at=I.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT,yt=M.__webglDepthbuffer;i.bindRenderbuffer(i.RENDERBUFFER,yt),i.framebufferRenderbuffer(i.FRAMEBUFFER,at,i.RENDERBUFFER,yt)}e.bindFramebuffer(i.FRAMEBUFFER,null)}function en(I,M,$){let ft=n.get(I);M!==void 0&&Be(ft.__webglFramebuffer,I,I.texture,i.COLOR_ATTACHMENT0,i.TEXTURE_2D,0),$!==void 0&&yn(I)}function fn(I){let M=I.texture,$=n.get(I),ft=n.get(M);I.addEventListener("dispose",z),U(I);let at=I.textures,yt=I.isWebGLCubeRenderTarget===!0,St=at.length>1;if(St||(ft.__webglTexture===void 0&&(ft.__webglTexture=i.createTexture()),ft.__version=M.version,o.memory.textures++),yt){$.__webglFramebuffer=[];for(let nt=0;nt<6;nt++)if(M.mipmaps.length>0){$.__webglFramebuffer[nt]=[];for(let rt=0;rt<M.mipmaps.length;rt++)$.__webglFramebuffer[nt][rt]=i.createFramebuffer()}else $.__webglFramebuffer[nt]=i.createFramebuffer()}else{if(M.mipmaps.length>0){$.__webglFramebuffer=[];for(let nt=0;nt<M.mipmaps.length;nt++)$.__webglFramebuffer[nt]=i.createFramebuffer()}else $.__webglFramebuffer=i.createFramebuffer();if(St)for(let nt=0,rt=at.length;nt<rt;nt++){let gt=n.get(at[nt]);gt.__webglTexture===void 0&&(gt.__webglTexture=i.createTexture(),o.memory.textures++)}if(I.samples>0&&Et(I)===!1){$.__webglMultisampledFramebuffer=i.createFramebuffer(),$.__webglColorRenderbuffer=[],e.bindFramebuffer(i.FRAMEBUFFER,$.__webglMultisampledFramebuffer);for(let nt=0;nt<at.length;nt++){let rt=at[nt];$.__webglColorRenderbuffer[nt]=i.createRenderbuffer(),i.bindRenderbuffer(i.RENDERBUFFER,$.__webglColorRenderbuffer[nt]);let gt=r.convert(rt.format,rt.colorSpace),B=r.convert(rt.type),ot=E(rt.internalFormat,gt,B,rt.normalized,rt.colorSpace,I.isXRRenderTarget===!0),it=he(I);i.renderbufferStorageMultisample(i.RENDERBUFFER,it,ot,I.width,I.height),i.framebufferRenderbuffer(i.FRAMEBUFFER,i.COLOR_ATTACHMENT0+nt,i.RENDERBUFFER,$.__webglColorRenderbuffer[nt])}i.bindRenderbuffer(i.RENDERBUFFER,null),I.depthBuffer&&($.__webglDepthRenderbuffer=i.createRenderbuffer(),Rn($.__webglDepthRenderbuffer,I,!0)),e.bindFramebuffer(i.FRAMEBUFFER,null)}}if(yt){e.bindTexture(i.TEXTURE_CUBE_MAP,ft.__webglTexture),ge(i.TEXTURE_CUBE_MAP,M);for(let nt=0;nt<6;nt++)if(M.mipmaps.length>0)for(let rt=0;rt<M.mipmaps.length;rt++)Be($.__webglFramebuffer[nt][rt],I,M,i.COLOR_ATTACHMENT0,i.TEXTURE_CUBE_MAP_POSITIVE_X+nt,rt);else Be($.__webglFramebuffer[nt],I,M,i.COLOR_ATTACHMENT0,i.TEXTURE_CUBE_MAP_POSITIVE_X+nt,0);A(M)?S(i.TEXTURE_CUBE_MAP):M.mipmaps.length>0&&i.texParameteri(i.TEXTURE_CUBE_MAP,i.TEXTURE_MAX_LEVEL,M.mipmaps.length-1),e.unbindTexture()}else if(St){for(let nt=0,rt=at.length;nt<rt;nt++){let gt=at[nt],B=n.get(gt),ot=i.TEXTURE_2D;(I.isWebGL3DRenderTarget||I.isWebGLArrayRenderTarget)&&(ot=I.isWebGL3DRenderTarget?i.TEXTURE_3D:i.TEXTURE_2D_ARRAY),e.bindTexture(ot,B.__webglTexture),ge(ot,gt),Be($.__webglFramebuffer,I,gt,i.COLOR_ATTACHMENT0+nt,ot,0),A(gt)&&S(ot)}e.unbindTexture()}else{let nt=i.TEXTURE_2D;if((I.isWebGL3DRenderTarget||I.isWebGLArrayRenderTarget)&&(nt=I.isWebGL3DRenderTarget?i.TEXTURE_3D:i.TEXTURE_2D_ARRAY),e.bindTexture(nt,ft.__webglTexture),ge(nt,M),M.mipmaps.length>0)for(let rt=0;rt<M.mipmaps.length;rt++)Be($.__webglFramebuffer[rt],I,M,i.COLOR_ATTACHMENT0,nt,rt);else Be($.__webglFramebuffer,I,M,i.COLOR_ATTACHMENT0,nt,0);A(M)?S(nt):M.mipmaps.length>0&&i.texParameteri(nt,i.TEXTURE_MAX_LEVEL,M.mipmaps.length-1),e.unbindTexture()}I.depthBuffer&&yn(I)}function k(I){let M=I.textures;for(let $=0,ft=M.length;$<ft;$++){let at=M[$];if(A(at)&&at.mipmapsAutoUpdate===!0){let yt=R(I),St=n.get(at).__webglTexture;e.bindTexture(yt,St),S(yt),e.unbindTexture()}}}let Lt=[];function Qt(I){if(I.samples>0){if(Et(I)===!1){let M=I.textures,$=I.width,ft=I.height,at=i.COLOR_BUFFER_BIT,yt=I.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT,St=n.get(I),nt=M.length>1;if(nt)for(let gt=0;gt<M.length;gt++)e.bindFramebuffer(i.FRAMEBUFFER,St.__webglMultisampledFramebuffer),i.framebufferRenderbuffer(i.FRAMEBUFFER,i.COLOR_ATTACHMENT0+gt,i.RENDERBUFFER,null),e.bindFramebuffer(i.FRAMEBUFFER,St.__webglFramebuffer),i.framebufferTexture2D(i.DRAW_FRAMEBUFFER,i.COLOR_ATTACHMENT0+gt,i.TEXTURE_2D,null,0);e.bindFramebuffer(i.READ_FRAMEBUFFER,St.__webglMultisampledFramebuffer),I.texture.mipmaps.length>0?e.bindFramebuffer(i.DRAW_FRAMEBUFFER,St.__webglFramebuffer[0]):e.bindFramebuffer(i.DRAW_FRAMEBUFFER,St.__webglFramebuffer);for(let gt=0;gt<M.length;gt++){if(I.resolveDepthBuffer&&(I.depthBuffer&&(at|=i.DEPTH_BUFFER_BIT),I.stencilBuffer&&I.resolveStencilBuffer&&(at|=i.STENCIL_BUFFER_BIT)),nt){i.framebufferRenderbuffer(i.READ_FRAMEBUFFER,i.COLOR_ATTACHMENT0,i.RENDERBUFFER,St.__webglColorRenderbuffer[gt]);let B=n.get(M[gt]).__webglTexture;i.framebufferTexture2D(i.DRAW_FRAMEBUFFER,i.COLOR_ATTACHMENT0,i.TEXTURE_2D,B,0)}i.blitFramebuffer(0,0,$,ft,0,0,$,ft,at,i.NEAREST),l===!0&&(Lt.length=0,Lt.push(i.COLOR_ATTACHMENT0+gt),I.depthBuffer&&I.storeMultisampledDepthBuffer===!1&&Lt.push(yt),i.invalidateFramebuffer(i.READ_FRAMEBUFFER,Lt))}if(e.bindFramebuffer(i.READ_FRAMEBUFFER,null),e.bindFramebuffer(i.DRAW_FRAMEBUFFER,null),nt)for(let gt=0;gt<M.length;gt++){e.bindFramebuffer(i.FRAMEBUFFER,St.__webglMultisampledFramebuffer),i.framebufferRenderbuffer(i.FRAMEBUFFER,i.COLOR_ATTACHMENT0+gt,i.RENDERBUFFER,St.__webglColorRenderbuffer[gt]);let B=n.get(M[gt]).__webglTexture;e.bindFramebuffer(i.FRAMEBUFFER,St.__webglFramebuffer),i.framebufferTexture2D(i.DRAW_FRAMEBUFFER,i.COLOR_ATTACHMENT0+gt,i.TEXTURE_2D,B,0)}e.bindFramebuffer(i.DRAW_FRAMEBUFFER,St.__webglMultisampledFramebuffer)}else if(I.depthBuffer&&I.storeMultisampledDepthBuffer===!1&&l){let M=I.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT;i.invalidateFramebuffer(i.DRAW_FRAMEBUFFER,[M])}}}function he(I){return Math.min(s.maxSamples,I.samples)}function Et(I){let M=n.get(I);return I.samples>0&&t.has("WEBGL_multisampled_render_to_texture")===!0&&M.__useRenderToTexture!==!1}function ze(I){let M=o.render.frame;f.get(I)!==M&&(f.set(I,M),I.update())}function Wt(I,M){let $=I.colorSpace,ft=I.format,at=I.type;return I.isCompressedTexture===!0||I.isVideoTexture===!0||$!==ha&&$!==Cs&&(Me.getTransfer($)===Le?(ft!==Vi||at!==ai)&&jt("WebGLTextures: sRGB encoded textures have to use RGBAFormat and UnsignedByteType."):se("WebGLTextures: Unsupported texture color space:",$)),M}function Kt(I){return typeof HTMLImageElement<"u"&&I instanceof HTMLImageElement?(c.width=I.naturalWidth||I.width,c.height=I.naturalHeight||I.height):typeof VideoFrame<"u"&&I instanceof VideoFrame?(c.width=I.displayWidth,c.height=I.displayHeight):(c.width=I.width,c.height=I.height),c}this.allocateTextureUnit=dt,this.resetTextureUnits=et,this.getTextureUnits=st,this.setTextureUnits=pt,this.setTexture2D=_t,this.setTexture2DArray=vt,this.setTexture3D=Pt,this.setTextureCube=Tt,this.rebindTextures=en,this.setupRenderTarget=fn,this.updateRenderTargetMipmap=k,this.updateMultisampleRenderTarget=Qt,this.setupDepthRenderbuffer=yn,this.setupFrameBufferTexture=Be,this.useMultisampledRTT=Et,this.dispose=G}function PT(i,t){function e(n,s=Cs){let r,o=Me.getTransfer(s);if(n===ai)return i.UNSIGNED_BYTE;if(n===Zc)return i.UNSIGNED_SHORT_4_4_4_4;if(n===Jc)return i.UNSIGNED_SHORT_5_5_5_1;if(n===wf)return i.UNSIGNED_INT_5_9_9_9_REV;if(n===Tf)return i.UNSIGNED_INT_10F_11F_11F_REV;if(n===Mf)return i.BYTE;if(n===bf)return i.SHORT;if(n===Eo)return i.UNSIGNED_SHORT;if(n===Yc)return i.INT;if(n===Bi)return i.UNSIGNED_INT;if(n===ki)return i.FLOAT;if(n===zi)return i.HALF_FLOAT;if(n===Ef)return i.ALPHA;if(n===Af)return i.RGB;if(n===Vi)return i.RGBA;if(n===bs)return i.DEPTH_COMPONENT;if(n===As)return i.DEPTH_STENCIL;if(n===Cf)return i.RED;if(n===Kc)return i.RED_INTEGER;if(n===Qs)return i.RG;if(n===jc)return i.RG_INTEGER;if(n===Qc)return i.RGBA_INTEGER;if(n===ka||n===za||n===Va||n===Ga)if(o===Le)if(r=t.get("WEBGL_compressed_texture_s3tc_srgb"),r!==null){if(n===ka)return r.COMPRESSED_SRGB_S3TC_DXT1_EXT;if(n===za)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT1_EXT;if(n===Va)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT3_EXT;if(n===Ga)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT5_EXT}else return null;else if(r=t.get("WEBGL_compressed_texture_s3tc"),r!==null){if(n===ka)return r.COMPRESSED_RGB_S3TC_DXT1_EXT;if(n===za)return r.COMPRESSED_RGBA_S3TC_DXT1_EXT;if(n===Va)return r.COMPRESSED_RGBA_S3TC_DXT3_EXT;if(n===Ga)return r.COMPRESSED_RGBA_S3TC_DXT5_EXT}else return null;if(n===th||n===eh||n===nh||n===ih)if(r=t.get("WEBGL_compressed_texture_pvrtc"),r!==null){if(n===th)return r.COMPRESSED_RGB_PVRTC_4BPPV1_IMG;if(n===eh)return r.COMPRESSED_RGB_PVRTC_2BPPV1_IMG;if(n===nh)return r.COMPRESSED_RGBA_PVRTC_4BPPV1_IMG;if(n===ih)return r.COMPRESSED_RGBA_PVRTC_2BPPV1_IMG}else return null;if(n===sh||n===rh||n===oh||n===ah||n===lh||n===Ha||n===ch)if(r=t.get("WEBGL_compressed_texture_etc"),r!==null){if(n===sh||n===rh)return o===Le?r.COMPRESSED_SRGB8_ETC2:r.COMPRESSED_RGB8_ETC2;if(n===oh)return o===Le?r.COMPRESSED_SRGB8_ALPHA8_ETC2_EAC:r.COMPRESSED_RGBA8_ETC2_EAC;if(n===ah)return r.COMPRESSED_R11_EAC;if(n===lh)return r.COMPRESSED_SIGNED_R11_EAC;if(n===Ha)return r.COMPRESSED_RG11_EAC;if(n===ch)return r.COMPRESSED_SIGNED_RG11_EAC}else return null;if(n===hh||n===uh||n===fh||n===dh||n===ph||n===mh||n===gh||n===_h||n===xh||n===yh||n===vh||n===Sh||n===Mh||n===bh)if(r=t.get("WEBGL_compressed_texture_astc"),r!==null){if(n===hh)return o===Le?r.COMPRESSED_SRGB8_ALPHA8_ASTC_4x4_KHR:r.COMPRESSED_RGBA_ASTC_4x4_KHR;if(n===uh)return o===Le?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x4_KHR:r.COMPRESSED_RGBA_ASTC_5x4_KHR;if(n===fh)return o===Le?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x5_KHR:r.COMPRESSED_RGBA_ASTC_5x5_KHR;if(n===dh)return o===Le?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x5_KHR:r.COMPRESSED_RGBA_ASTC_6x5_KHR;if(n===ph)return o===Le?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x6_KHR:r.COMPRESSED_RGBA_ASTC_6x6_KHR;if(n===mh)return o===Le?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x5_KHR:r.COMPRESSED_RGBA_ASTC_8x5_KHR;if(n===gh)return o===Le?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x6_KHR:r.COMPRESSED_RGBA_ASTC_8x6_KHR;if(n===_h)return o===Le?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x8_KHR:r.COMPRESSED_RGBA_ASTC_8x8_KHR;if(n===xh)return o===Le?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x5_KHR:r.COMPRESSED_RGBA_ASTC_10x5_KHR;if(n===yh)return o===Le?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x6_KHR:r.COMPRESSED_RGBA_ASTC_10x6_KHR;if(n===vh)return o===Le?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x8_KHR:r.COMPRESSED_RGBA_ASTC_10x8_KHR;if(n===Sh)return o===Le?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x10_KHR:r.COMPRESSED_RGBA_ASTC_10x10_KHR;if(n===Mh)return o===Le?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x10_KHR:r.COMPRESSED_RGBA_ASTC_12x10_KHR;if(n===bh)return o===Le?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x12_KHR:r.COMPRESSED_RGBA_ASTC_12x12_KHR}else return null;if(n===wh||n===Th||n===Eh)if(r=t.get("EXT_texture_compression_bptc"),r!==null){if(n===wh)return o===Le?r.COMPRESSED_SRGB_ALPHA_BPTC_UNORM_EXT:r.COMPRESSED_RGBA_BPTC_UNORM_EXT;if(n===Th)return r.COMPRESSED_RGB_BPTC_SIGNED_FLOAT_EXT;if(n===Eh)return r.COMPRESSED_RGB_BPTC_UNSIGNED_FLOAT_EXT}else return null;if(n===Ah||n===Ch||n===Wa||n===Rh)if(r=t.get("EXT_texture_compression_rgtc"),r!==null){if(n===Ah)return r.COMPRESSED_RED_RGTC1_EXT;if(n===Ch)return r.COMPRESSED_SIGNED_RED_RGTC1_EXT;if(n===Wa)return r.COMPRESSED_RED_GREEN_RGTC2_EXT;if(n===Rh)return r.COMPRESSED_SIGNED_RED_GREEN_RGTC2_EXT}else return null;return n===Sr?i.UNSIGNED_INT_24_8:i[n]!==void 0?i[n]:null}return{convert:e}}var IT=`
void main() {

	gl_Position = vec4( position, 1.0 );

}`,LT=`
uniform sampler2DArray depthColor;
uniform float depthWidth;
uniform float depthHeight;

void main() {

	vec2 coord = vec2( gl_FragCoord.x / depthWidth, gl_FragCoord.y / depthHeight );

	if ( coord.x >= 1.0 ) {

		gl_FragDepth = texture( depthColor, vec3( coord.x - 1.0, coord.y, 1 ) ).r;

	} else {

		gl_FragDepth = texture( depthColor, vec3( coord.x, coord.y, 0 ) ).r;

	}

}`,Kf=class{constructor(){this.texture=null,this.mesh=null,this.depthNear=0,this.depthFar=0}init(t,e){if(this.texture===null){let n=new wa(t.texture);(t.depthNear!==e.depthNear||t.depthFar!==e.depthFar)&&(this.depthNear=t.depthNear,this.depthFar=t.depthFar),this.texture=n}}getMesh(t){if(this.texture!==null&&this.mesh===null){let e=t.cameras[0].viewport,n=new rs({vertexShader:IT,fragmentShader:LT,uniforms:{depthColor:{value:this.texture},depthWidth:{value:e.z},depthHeight:{value:e.w}}});this.mesh=new bn(new Ea(20,20),n)}return this.mesh}reset(){this.texture=null,this.mesh=null}getDepthTexture(){return this.texture}},jf=class extends Oi{constructor(t,e){super();let n=this,s=null,r=1,o=null,a="local-floor",l=1,c=null,f=null,u=null,h=null,d=null,p=null,_=typeof XRWebGLBinding<"u",g=new Kf,m={},v=e.getContextAttributes(),A=null,S=null,R=[],E=[],x=new Jt,T=null,U=null,N=new Kn;N.viewport=new Qe;let L=new Kn;L.viewport=new Qe;let z=[N,L],O=new Wc,P=null,G=null;this.cameraAutoUpdate=!0,this.enabled=!1,this.isPresenting=!1,this.getController=function(Q){let _t=R[Q];return _t===void 0&&(_t=new _o,R[Q]=_t),_t.getTargetRaySpace()},this.getControllerGrip=function(Q){let _t=R[Q];return _t===void 0&&(_t=new _o,R[Q]=_t),_t.getGripSpace()},this.getHand=function(Q){let _t=R[Q];return _t===void 0&&(_t=new _o,R[Q]=_t),_t.getHandSpace()};function q(Q){let _t=E.indexOf(Q.inputSource);if(_t===-1)return;let vt=R[_t];vt!==void 0&&(vt.update(Q.inputSource,Q.frame,c||o),vt.dispatchEvent({type:Q.type,data:Q.inputSource}))}function H(){s.removeEventListener("select",q),s.removeEventListener("selectstart",q),s.removeEventListener("selectend",q),s.removeEventListener("squeeze",q),s.removeEventListener("squeezestart",q),s.removeEventListener("squeezeend",q),s.removeEventListener("end",H),s.removeEventListener("inputsourceschange",ct);for(let Q=0;Q<R.length;Q++){let _t=E[Q];_t!==null&&(E[Q]=null,R[Q].disconnect(_t))}P=null,G=null,g.reset();for(let Q in m)delete m[Q];if(t.setRenderTarget(A),d=null,h=null,u=null,s=null,S=null,dt.stop(),n.isPresenting=!1,t.setPixelRatio(T),t.setSize(x.width,x.height,!1),U!==null){let Q=U.camera;Q.fov=U.fov,Q.zoom=U.zoom,Q.updateProjectionMatrix(),U=null}n.dispatchEvent({type:"sessionend"})}this.setFramebufferScaleFactor=function(Q){r=Q,n.isPresenting===!0&&jt("WebXRManager: Cannot change framebuffer scale while presenting.")},this.setReferenceSpaceType=function(Q){a=Q,n.isPresenting===!0&&jt("WebXRManager: Cannot change reference space type while presenting.")},this.getReferenceSpace=function(){return c||o},this.setReferenceSpace=function(Q){c=Q},this.getBaseLayer=function(){return h!==null?h:d},this.getBinding=function(){return u===null&&_&&(u=new XRWebGLBinding(s,e)),u},this.getFrame=function(){return p},this.getSession=function(){return s},this.setSession=async function(Q){if(s=Q,s!==null){if(A=t.getRenderTarget(),s.addEventListener("select",q),s.addEventListener("selectstart",q),s.addEventListener("selectend",q),s.addEventListener("squeeze",q),s.addEventListener("squeezestart",q),s.addEventListener("squeezeend",q),s.addEventListener("end",H),s.addEventListener("inputsourceschange",ct),v.xrCompatible!==!0&&await e.makeXRCompatible(),T=t.getPixelRatio(),t.getSize(x),_&&"createProjectionLayer"in XRWebGLBinding.prototype){let vt=null,Pt=null,Tt=null;v.depth&&(Tt=v.stencil?e.DEPTH24_STENCIL8:e.DEPTH_COMPONENT24,vt=v.stencil?As:bs,Pt=v.stencil?Sr:Bi);let Yt={colorFormat:e.RGBA8,depthFormat:Tt,scaleFactor:r};u=this.getBinding(),h=u.createProjectionLayer(Yt),s.updateRenderState({layers:[h]}),t.setPixelRatio(1),t.setSize(h.textureWidth,h.textureHeight,!1),S=new gi(h.textureWidth,h.textureHeight,{format:Vi,type:ai,depthTexture:new Ts(h.textureWidth,h.textureHeight,Pt,void 0,void 0,void 0,void 0,void 0,void 0,vt),stencilBuffer:v.stencil,colorSpace:t.outputColorSpace,samples:v.antialias?4:0,resolveDepthBuffer:h.ignoreDepthValues===!1,resolveStencilBuffer:h.ignoreDepthValues===!1,storeMultisampledDepthBuffer:h.ignoreDepthValues===!1,storeMultisampledStencilBuffer:h.ignoreDepthValues===!1})}else{let vt={antialias:v.antialias,alpha:!0,depth:v.depth,stencil:v.stencil,framebufferScaleFactor:r};d=new XRWebGLLayer(s,e,vt),s.updateRenderState({baseLayer:d}),t.setPixelRatio(1),t.setSize(d.framebufferWidth,d.framebufferHeight,!1),S=new gi(d.framebufferWidth,d.framebufferHeight,{format:Vi,type:ai,colorSpace:t.outputColorSpace,stencilBuffer:v.stencil,resolveDepthBuffer:d.ignoreDepthValues===!1,resolveStencilBuffer:d.ignoreDepthValues===!1,storeMultisampledDepthBuffer:d.ignoreDepthValues===!1,storeMultisampledStencilBuffer:d.ignoreDepthValues===!1})}S.isXRRenderTarget=!0,this.setFoveation(l),c=null,o=await s.requestReferenceSpace(a),dt.setContext(s),dt.start(),n.isPresenting=!0,n.dispatchEvent({type:"sessionstart"})}},this.getEnvironmentBlendMode=function(){if(s!==null)return s.environmentBlendMode},this.getDepthTexture=function(){return g.getDepthTexture()};function ct(Q){for(let _t=0;_t<Q.removed.length;_t++){let vt=Q.removed[_t],Pt=E.indexOf(vt);Pt>=0&&(E[Pt]=null,R[Pt].disconnect(vt))}for(let _t=0;_t<Q.added.length;_t++){let vt=Q.added[_t],Pt=E.indexOf(vt);if(Pt===-1){for(let Yt=0;Yt<R.length;Yt++)if(Yt>=E.length){E.push(vt),Pt=Yt;break}else if(E[Yt]===null){E[Yt]=vt,Pt=Yt;break}if(Pt===-1)break}let Tt=R[Pt];Tt&&Tt.connect(vt)}}function K(Q,_t){_t===null?Q.matrixWorld.copy(Q.matrix):Q.matrixWorld.multiplyMatrices(_t.matrixWorld,Q.matrix),Q.matrixWorldInverse.copy(Q.matrixWorld).invert()}this.updateCamera=function(Q){if(s===null)return;let _t=Q.near,vt=Q.far;g.texture!==null&&(g.depthNear>0&&(_t=g.depthNear),g.depthFar>0&&(vt=g.depthFar)),O.near=L.near=N.near=_t,O.far=L.far=N.far=vt,(P!==O.near||G!==O.far)&&(s.updateRenderState({depthNear:O.near,depthFar:O.far}),P=O.near,G=O.far),O.layers.mask=Q.layers.mask|6,N.layers.mask=O.layers.mask&-5,L.layers.mask=O.layers.mask&-3;let Pt=Q.parent,Tt=O.cameras;K(O,Pt);for(let Yt=0;Yt<Tt.length;Yt++)K(Tt[Yt],Pt);O.projectionMatrix.copy(N.projectionMatrix),O.projectionMatrixInverse.copy(N.projectionMatrixInverse),U===null&&Q.isPerspectiveCamera&&(U={camera:Q,fov:Q.fov,zoom:Q.zoom}),et(Q,O,Pt)};function et(Q,_t,vt){vt===null?Q.matrix.copy(_t.matrixWorld):(Q.matrix.copy(vt.matrixWorld),Q.matrix.invert(),Q.matrix.multiply(_t.matrixWorld)),Q.matrix.decompose(Q.position,Q.quaternion,Q.scale),Q.updateMatrixWorld(!0),Q.projectionMatrix.copy(_t.projectionMatrix),Q.projectionMatrixInverse.copy(_t.projectionMatrixInverse),Q.isPerspectiveCamera&&(Q.fov=mo*2*Math.atan(1/Q.projectionMatrix.elements[5]),Q.zoom=1)}this.getCamera=function(){return O},this.getFoveation=function(){if(!(h===null&&d===null))return l},this.setFoveation=function(Q){l=Q,h!==null&&(h.fixedFoveation=Q),d!==null&&d.fixedFoveation!==void 0&&(d.fixedFoveation=Q)},this.hasDepthSensing=function(){return g.texture!==null},this.getDepthSensingMesh=function(){return g.getMesh(O)},this.getCameraTexture=function(Q){return m[Q]};let st=null;function pt(Q,_t){if(f=_t.getViewerPose(c||o),p=_t,f!==null){let vt=f.views;d!==null&&(t.setRenderTargetFramebuffer(S,d.framebuffer),t.setRenderTarget(S));let Pt=!1;vt.length!==O.cameras.length&&(O.cameras.length=0,Pt=!0);for(let Xt=0;Xt<vt.length;Xt++){let ge=vt[Xt],de=null;if(d!==null)de=d.getViewport(ge);else{let Ke=u.getViewSubImage(h,ge);de=Ke.viewport,Xt===0&&(t.setRenderTargetTextures(S,Ke.colorTexture,Ke.depthStencilTexture),t.setRenderTarget(S))}let ae=z[Xt];ae===void 0&&(ae=new Kn,ae.layers.enable(Xt),ae.viewport=new Qe,z[Xt]=ae),ae.matrix.fromArray(ge.transform.matrix),ae.matrix.decompose(ae.position,ae.quaternion,ae.scale),ae.projectionMatrix.fromArray(ge.projectionMatrix),ae.projectionMatrixInverse.copy(ae.projectionMatrix).invert(),ae.viewport.set(de.x,de.y,de.width,de.height),Xt===0&&(O.matrix.copy(ae.matrix),O.matrix.decompose(O.position,O.quaternion,O.scale)),Pt===!0&&O.cameras.push(ae)}let Tt=s.enabledFeatures;if(Tt&&Tt.includes("depth-sensing")&&s.depthUsage=="gpu-optimized"&&_){u=n.getBinding();let Xt=u.getDepthInformation(vt[0]);Xt&&Xt.isValid&&Xt.texture&&g.init(Xt,s.renderState)}if(Tt&&Tt.includes("camera-access")&&_){t.state.unbindTexture(),u=n.getBinding();for(let Xt=0;Xt<vt.length;Xt++){let ge=vt[Xt].camera;if(ge){let de=m[ge];de||(de=new wa,m[ge]=de);let ae=u.getCameraImage(ge);de.sourceTexture=ae}}}}for(let vt=0;vt<R.length;vt++){let Pt=E[vt],Tt=R[vt];Pt!==null&&Tt!==void 0&&Tt.update(Pt,_t,c||o)}st&&st(Q,_t),_t.detectedPlanes&&n.dispatchEvent({type:"planesdetected",data:_t}),p=null}let dt=new Jg;dt.setAnimationLoop(pt),this.setAnimationLoop=function(Q){st=Q},this.dispose=function(){}}},DT=new De,o0=new oe;o0.set(-1,0,0,0,1,0,0,0,1);function NT(i,t){function e(g,m){g.matrixAutoUpdate===!0&&g.updateMatrix(),m.value.copy(g.matrix)}function n(g,m){m.color.getRGB(g.fogColor.value,kf(i)),m.isFog?(g.fogNear.value=m.near,g.fogFar.value=m.far):m.isFogExp2&&(g.fogDensity.value=m.density)}function s(g,m,v,A,S){m.isNodeMaterial?m.uniformsNeedUpdate=!1:m.isMeshBasicMaterial?r(g,m):m.isMeshLambertMaterial?(r(g,m),m.envMap&&(g.envMapIntensity.value=m.envMapIntensity)):m.isMeshToonMaterial?(r(g,m),u(g,m)):m.isMeshPhongMaterial?(r(g,m),f(g,m),m.envMap&&(g.envMapIntensity.value=m.envMapIntensity)):m.isMeshStandardMaterial?(r(g,m),h(g,m),m.isMeshPhysicalMaterial&&d(g,m,S)):m.isMeshMatcapMaterial?(r(g,m),p(g,m)):m.isMeshDepthMaterial?r(g,m):m.isMeshDistanceMaterial?(r(g,m),_(g,m)):m.isMeshNormalMaterial?r(g,m):m.isLineBasicMaterial?(o(g,m),m.isLineDashedMaterial&&a(g,m)):m.isPointsMaterial?l(g,m,v,A):m.isSpriteMaterial?c(g,m):m.isShadowMaterial?(g.color.value.copy(m.color),g.opacity.value=m.opacity):m.isShaderMaterial&&(m.uniformsNeedUpdate=!1)}function r(g,m){g.opacity.value=m.opacity,m.color&&g.diffuse.value.copy(m.color),m.emissive&&g.emissive.value.copy(m.emissive).multiplyScalar(m.emissiveIntensity),m.map&&(g.map.value=m.map,e(m.map,g.mapTransform)),m.alphaMap&&(g.alphaMap.value=m.alphaMap,e(m.alphaMap,g.alphaMapTransform)),m.bumpMap&&(g.bumpMap.value=m.bumpMap,e(m.bumpMap,g.bumpMapTransform),g.bumpScale.value=m.bumpScale,m.side===ei&&(g.bumpScale.value*=-1)),m.normalMap&&(g.normalMap.value=m.normalMap,e(m.normalMap,g.normalMapTransform),g.normalScale.value.copy(m.normalScale),m.side===ei&&g.normalScale.value.negate()),m.displacementMap&&(g.displacementMap.value=m.displacementMap,e(m.displacementMap,g.displacementMapTransform),g.displacementScale.value=m.displacementScale,g.displacementBias.value=m.displacementBias),m.emissiveMap&&(g.emissiveMap.value=m.emissiveMap,e(m.emissiveMap,g.emissiveMapTransform)),m.specularMap&&(g.specularMap.value=m.specularMap,e(m.specularMap,g.specularMapTransform)),m.alphaTest>0&&(g.alphaTest.value=m.alphaTest);let v=t.get(m),A=v.envMap,S=v.envMapRotation;A&&(g.envMap.value=A,g.envMapRotation.value.setFromMatrix4(DT.makeRotationFromEuler(S)).transpose(),A.isCubeTexture&&A.isRenderTargetTexture===!1&&g.envMapRotation.value.premultiply(o0),g.reflectivity.value=m.reflectivity,g.ior.value=m.ior,g.refractionRatio.value=m.refractionRatio),m.lightMap&&(g.lightMap.value=m.lightMap,g.lightMapIntensity.value=m.lightMapIntensity,e(m.lightMap,g.lightMapTransform)),m.aoMap&&(g.aoMap.value=m.aoMap,g.aoMapIntensity.value=m.aoMapIntensity,e(m.aoMap,g.aoMapTransform))}function o(g,m){g.diffuse.value.copy(m.color),g.opacity.value=m.opacity,m.map&&(g.map.value=m.map,e(m.map,g.mapTransform))}function a(g,m){g.dashSize.value=m.dashSize,g.totalSize.value=m.dashSize+m.gapSize,g.scale.value=m.scale}function l(g,m,v,A){g.diffuse.value.copy(m.color),g.opacity.value=m.opacity,g.size.value=m.size*v,g.scale.value=A*.5,m.map&&(g.map.value=m.map,e(m.map,g.uvTransform)),m.alphaMap&&(g.alphaMap.value=m.alphaMap,e(m.alphaMap,g.alphaMapTransform)),m.alphaTest>0&&(g.alphaTest.value=m.alphaTest)}function c(g,m){g.diffuse.value.copy(m.color),g.opacity.value=m.opacity,g.rotation.value=m.rotation,m.map&&(g.map.value=m.map,e(m.map,g.mapTransform)),m.alphaMap&&(g.alphaMap.value=m.alphaMap,e(m.alphaMap,g.alphaMapTransform)),m.alphaTest>0&&(g.alphaTest.value=m.alphaTest)}function f(g,m){g.specular.value.copy(m.specular),g.shininess.value=Math.max(m.shininess,1e-4)}function u(g,m){m.gradientMap&&(g.gradientMap.value=m.gradientMap)}function h(g,m){g.metalness.value=m.metalness,m.metalnessMap&&(g.metalnessMap.value=m.metalnessMap,e(m.metalnessMap,g.metalnessMapTransform)),g.roughness.value=m.roughness,m.roughnessMap&&(g.roughnessMap.value=m.roughnessMap,e(m.roughnessMap,g.roughnessMapTransform)),m.envMap&&(g.envMapIntensity.value=m.envMapIntensity)}function d(g,m,v){g.ior.value=m.ior,m.diffuseRoughness>0&&(g.diffuseRoughness.value=m.diffuseRoughness,m.diffuseRoughnessMap&&(g.diffuseRoughnessMap.value=m.diffuseRoughnessMap,e(m.diffuseRoughnessMap,g.diffuseRoughnessMapTransform))),m.sheen>0&&(g.sheenColor.value.copy(m.sheenColor).multiplyScalar(m.sheen),g.sheenRoughness.value=m.sheenRoughness,m.sheenColorMap&&(g.sheenColorMap.value=m.sheenColorMap,e(m.sheenColorMap,g.sheenColorMapTransform)),m.sheenRoughnessMap&&(g.sheenRoughnessMap.value=m.sheenRoughnessMap,e(m.sheenRoughnessMap,g.sheenRoughnessMapTransform))),m.clearcoat>0&&(g.clearcoat.value=m.clearcoat,g.clearcoatRoughness.value=m.clearcoatRoughness,m.clearcoatMap&&(g.clearcoatMap.value=m.clearcoatMap,e(m.clearcoatMap,g.clearcoatMapTransform)),m.clearcoatRoughnessMap&&(g.clearcoatRoughnessMap.value=m.clearcoatRoughnessMap,e(m.clearcoatRoughnessMap,g.clearcoatRoughnessMapTransform)),m.clearcoatNormalMap&&(g.clearcoatNormalMap.value=m.clearcoatNormalMap,e(m.clearcoatNormalMap,g.clearcoatNormalMapTransform),g.clearcoatNormalScale.value.copy(m.clearcoatNormalScale),m.side===ei&&g.clearcoatNormalScale.value.negate())),m.dispersion>0&&(g.dispersion.value=m.dispersion),m.retroreflectivity>0&&(g.retroreflectivity.value=m.retroreflectivity),m.iridescence>0&&(g.iridescence.value=m.iridescence,g.iridescenceIOR.value=m.iridescenceIOR,g.iridescenceThicknessMinimum.value=m.iridescenceThicknessMinimum,g.iridescenceThicknessMaximum.value=m.iridescenceThicknessMaximum,m.iridescenceMap&&(g.iridescenceMap.value=m.iridescenceMap,e(m.iridescenceMap,g.iridescenceMapTransform)),m.iridescenceThicknessMap&&(g.iridescenceThicknessMap.value=m.iridescenceThicknessMap,e(m.iridescenceThicknessMap,g.iridescenceThicknessMapTransform))),m.transmission>0&&(g.transmission.value=m.transmission,g.transmissionSamplerMap.value=v.texture,g.transmissionSamplerSize.value.set(v.width,v.height),m.transmissionMap&&(g.transmissionMap.value=m.transmissionMap,e(m.transmissionMap,g.transmissionMapTransform)),g.thickness.value=m.thickness,m.thicknessMap&&(g.thicknessMap.value=m.thicknessMap,e(m.thicknessMap,g.thicknessMapTransform)),g.attenuationDistance.value=m.attenuationDistance,g.attenuationColor.value.copy(m.attenuationColor)),m.anisotropy>0&&(g.anisotropyVector.value.set(m.anisotropy*Math.cos(m.anisotropyRotation),m.anisotropy*Math.sin(m.anisotropyRotation)),m.anisotropyMap&&(g.anisotropyMap.value=m.anisotropyMap,e(m.anisotropyMap,g.anisotropyMapTransform))),g.specularIntensity.value=m.specularIntensity,g.specularColor.value.copy(m.specularColor),m.specularColorMap&&(g.specularColorMap.value=m.specularColorMap,e(m.specularColorMap,g.specularColorMapTransform)),m.specularIntensityMap&&(g.specularIntensityMap.value=m.specularIntensityMap,e(m.specularIntensityMap,g.specularIntensityMapTransform))}function p(g,m){m.matcap&&(g.matcap.value=m.matcap)}function _(g,m){let v=t.get(m).light;g.referencePosition.value.setFromMatrixPosition(v.matrixWorld),g.nearDistance.value=v.shadow.camera.near,g.farDistance.value=v.shadow.camera.far}return{refreshFogUniforms:n,refreshMaterialUniforms:s}}function UT(i,t,e,n){let s={},r={};function o(v,A){let S=A.program;n.uniformBlockBinding(v,S,s[v.id])}function a(v,A){let S=s[v.id];S===void 0&&(p(v),S=l(v),s[v.id]=S,v.addEventListener("dispose",g));let R=A.program;n.updateUBOMapping(v,R);let E=t.render.frame;r[v.id]!==E&&(c(v),r[v.id]=E)}function l(v){let A=i.createBuffer(),S=v.__size,R=v.usage;return i.bindBuffer(i.UNIFORM_BUFFER,A),i.bufferData(i.UNIFORM_BUFFER,S,R),i.bindBuffer(i.UNIFORM_BUFFER,null),A}function c(v){let A=s[v.id],S=v.uniforms,R=v.__cache;i.bindBuffer(i.UNIFORM_BUFFER,A);for(let E=0,x=S.length;E<x;E++){let T=S[E];if(Array.isArray(T))for(let U=0,N=T.length;U<N;U++)f(T[U],E,U,R);else f(T,E,0,R)}i.bindBuffer(i.UNIFORM_BUFFER,null)}function f(v,A,S,R){if(h(v,A,S,R)===!0){let E=v.__offset,x=v.value;if(Array.isArray(x)){let T=0;for(let U=0;U<x.length;U++){let N=x[U],L=_(N,!0);u(N,v.__data,T),T+=L.storage/Float32Array.BYTES_PER_ELEMENT}}else u(x,v.__data,0);i.bufferSubData(i.UNIFORM_BUFFER,E,v.__data)}}function u(v,A,S){typeof v=="number"||typeof v=="boolean"?A[S]=v:v.isMatrix3?(A[S]=v.elements[0],A[S+1]=v.elements[1],A[S+2]=v.elements[2],A[S+3]=0,A[S+4]=v.elements[3],A[S+5]=v.elements[4],A[S+6]=v.elements[5],A[S+7]=0,A[S+8]=v.elements[6],A[S+9]=v.elements[7],A[S+10]=v.elements[8],A[S+11]=0):ArrayBuffer.isView(v)?A.set(v.subarray(0,A.length-S),S):v.toArray(A,S)}function h(v,A,S,R){let E=v.value,x=A+"_"+S;if(Array.isArray(E)){R[x]===void 0&&(R[x]=[]);let T=R[x],U=!1;for(let N=0;N<E.length;N++)d(E[N],T,N)===!0&&(U=!0);return U}return d(E,R,x)}function d(v,A,S){if(A[S]===void 0)return typeof v=="number"||typeof v=="boolean"?A[S]=v:ArrayBuffer.isView(v)?A[S]=v.slice():A[S]=v.clone(),!0;{let R=A[S];if(typeof v=="number"||typeof v=="boolean"){if(R!==v)return A[S]=v,!0}else{if(ArrayBuffer.isView(v))return!0;if(R.equals(v)===!1)return R.copy(v),!0}}return!1}function p(v){let A=v.uniforms,S=0,R=16;for(let x=0,T=A.length;x<T;x++){let U=Array.isArray(A[x])?A[x]:[A[x]];for(let N=0,L=U.length;N<L;N++){let z=U[N],O=Array.isArray(z.value)?z.value:[z.value],P=Array.isArray(A[x])||Array.isArray(z.value),G=S;for(let H=0,ct=O.length;H<ct;H++){let K=O[H],et=_(K,P),st=S%R,pt=st%et.boundary,dt=st+pt;S+=pt,dt!==0&&R-dt<et.storage&&(S+=R-dt),H===0&&(G=S),S+=et.storage}let q=z.type==="int"?Int32Array:z.type==="uint"?Uint32Array:Float32Array;z.__data=new q((S-G)/Float32Array.BYTES_PER_ELEMENT),z.__offset=G}}let E=S%R;return E>0&&(S+=R-E),v.__size=S,v.__cache={},this}function _(v,A){let S={boundary:0,storage:0};return typeof v=="number"||typeof v=="boolean"?(S.boundary=4,S.storage=4):v.isVector2?(S.boundary=8,S.storage=8):v.isVector3||v.isColor?(S.boundary=16,S.storage=12):v.isVector4?(S.boundary=16,S.storage=16):v.isMatrix3?(S.boundary=16,S.storage=48):v.isMatrix4?(S.boundary=16,S.storage=64):v.isTexture?jt("WebGLRenderer: Texture samplers can not be part of an uniforms group."):ArrayBuffer.isView(v)?(S.boundary=16,S.storage=v.byteLength):jt("WebGLRenderer: Unsupported uniform value type.",v),A===!0&&(S.boundary=16,S.storage=Math.ceil(S.storage/16)*16),S}function g(v){let A=v.target;A.removeEventListener("dispose",g),i.deleteBuffer(s[A.id]),delete s[A.id],delete r[A.id]}function m(){for(let v in s)i.deleteBuffer(s[v]);s={},r={}}return{bind:o,update:a,dispose:m}}var FT=new Uint16Array([12469,15057,12620,14925,13266,14620,13807,14376,14323,13990,14545,13625,14713,13328,14840,12882,14931,12528,14996,12233,15039,11829,15066,11525,15080,11295,15085,10976,15082,10705,15073,10495,13880,14564,13898,14542,13977,14430,14158,14124,14393,13732,14556,13410,14702,12996,14814,12596,14891,12291,14937,11834,14957,11489,14958,11194,14943,10803,14921,10506,14893,10278,14858,9960,14484,14039,14487,14025,14499,13941,14524,13740,14574,13468,14654,13106,14743,12678,14818,12344,14867,11893,14889,11509,14893,11180,14881,10751,14852,10428,14812,10128,14765,9754,14712,9466,14764,13480,14764,13475,14766,13440,14766,13347,14769,13070,14786,12713,14816,12387,14844,11957,14860,11549,14868,11215,14855,10751,14825,10403,14782,10044,14729,9651,14666,9352,14599,9029,14967,12835,14966,12831,14963,12804,14954,12723,14936,12564,14917,12347,14900,11958,14886,11569,14878,11247,14859,10765,14828,10401,14784,10011,14727,9600,14660,9289,14586,8893,14508,8533,15111,12234,15110,12234,15104,12216,15092,12156,15067,12010,15028,11776,14981,11500,14942,11205,14902,10752,14861,10393,14812,9991,14752,9570,14682,9252,14603,8808,14519,8445,14431,8145,15209,11449,15208,11451,15202,11451,15190,11438,15163,11384,15117,11274,15055,10979,14994,10648,14932,10343,14871,9936,14803,9532,14729,9218,14645,8742,14556,8381,14461,8020,14365,7603,15273,10603,15272,10607,15267,10619,15256,10631,15231,10614,15182,10535,15118,10389,15042,10167,14963,9787,14883,9447,14800,9115,14710,8665,14615,8318,14514,7911,14411,7507,14279,7198,15314,9675,15313,9683,15309,9712,15298,9759,15277,9797,15229,9773,15166,9668,15084,9487,14995,9274,14898,8910,14800,8539,14697,8234,14590,7790,14479,7409,14367,7067,14178,6621,15337,8619,15337,8631,15333,8677,15325,8769,15305,8871,15264,8940,15202,8909,15119,8775,15022,8565,14916,8328,14804,8009,14688,7614,14569,7287,14448,6888,14321,6483,14088,6171,15350,7402,15350,7419,15347,7480,15340,7613,15322,7804,15287,7973,15229,8057,15148,8012,15046,7846,14933,7611,14810,7357,14682,7069,14552,6656,14421,6316,14251,5948,14007,5528,15356,5942,15356,5977,15353,6119,15348,6294,15332,6551,15302,6824,15249,7044,15171,7122,15070,7050,14949,6861,14818,6611,14679,6349,14538,6067,14398,5651,14189,5311,13935,4958,15359,4123,15359,4153,15356,4296,15353,4646,15338,5160,15311,5508,15263,5829,15188,6042,15088,6094,14966,6001,14826,5796,14678,5543,14527,5287,14377,4985,14133,4586,13869,4257,15360,1563,15360,1642,15358,2076,15354,2636,15341,3350,15317,4019,15273,4429,15203,4732,15105,4911,14981,4932,14836,4818,14679,4621,14517,4386,14359,4156,14083,3795,13808,3437,15360,122,15360,137,15358,285,15355,636,15344,1274,15322,2177,15281,2765,15215,3223,15120,3451,14995,3569,14846,3567,14681,3466,14511,3305,14344,3121,14037,2800,13753,2467,15360,0,15360,1,15359,21,15355,89,15346,253,15325,479,15287,796,15225,1148,15133,1492,15008,1749,14856,1882,14685,1886,14506,1783,14324,1608,13996,1398,13702,1183]),ls=null;function OT(){return ls===null&&(ls=new Ec(FT,16,16,Qs,zi),ls.name="DFG_LUT",ls.minFilter=jn,ls.magFilter=jn,ls.wrapS=es,ls.wrapT=es,ls.generateMipmaps=!1,ls.needsUpdate=!0),ls}var Uh=class{constructor(t={}){let{canvas:e=vg(),context:n=null,depth:s=!0,stencil:r=!1,alpha:o=!1,antialias:a=!1,premultipliedAlpha:l=!0,preserveDrawingBuffer:c=!1,powerPreference:f="default",failIfMajorPerformanceCaveat:u=!1,reversedDepthBuffer:h=!1,outputBufferType:d=ai}=t;this.isWebGLRenderer=!0;let p;if(n!==null){if(typeof WebGLRenderingContext<"u"&&n instanceof WebGLRenderingContext)throw new Error("THREE.WebGLRenderer: WebGL 1 is not supported since r163.");p=n.getContextAttributes().alpha}else p=o;let _=d,g=new Set([Qc,jc,Kc]),m=new Set([ai,Bi,Eo,Sr,Zc,Jc]),v=new Uint32Array(4),A=new Int32Array(4),S={textures:[],min:[],max:[],resolution:[]},R=null,E=null,x=[],T=[],U=null;this.domElement=e,this.debug={checkShaderErrors:!0,diagnostics:{keywords:!1},onShaderError:null},this.autoClear=!0,this.autoClearColor=!0,this.autoClearDepth=!0,this.autoClearStencil=!0,this.sortObjects=!0,this.clippingPlanes=[],this.localClippingEnabled=!1,this.toneMapping=as,this.toneMappingExposure=1,this.transmissionResolutionScale=1;let N=this,L=!1,z=null,O=null,P=null,G=null;this._outputColorSpace=Jn;let q=0,H=0,ct=null,K=-1,et=null,st=new Qe,pt=new Qe,dt=null,Q=new ue(0),_t=0,vt=e.width,Pt=e.height,Tt=1,Yt=null,ce=null,Xt=new Qe(0,0,vt,Pt),ge=new Qe(0,0,vt,Pt),de=!1,ae=new qs,Ke=new Ac,He=!1,un=!1,Be=new De,Rn=new X,we=new Qe,yn={background:null,fog:null,environment:null,overrideMaterial:null,isScene:!0},en=!1;function fn(){return ct===null?Tt:1}let k=n;function Lt(w,V){return e.getContext(w,V)}let Qt,he,Et,ze,Wt,Kt,I,M,$,ft,at,yt,St,nt,rt,gt,B,ot,it,At,xt,wt,qt;try{let w={alpha:!0,depth:s,stencil:r,antialias:a,premultipliedAlpha:l,preserveDrawingBuffer:c,powerPreference:f,failIfMajorPerformanceCaveat:u};if("setAttribute"in e&&e.setAttribute("data-engine",`three.js r${"187"}`),e.addEventListener("webglcontextlost",Vt,!1),e.addEventListener("webglcontextrestored",ie,!1),e.addEventListener("webglcontextcreationerror",It,!1),k===null){let V="webgl2";if(k=Lt(V,w),k===null)throw Lt(V)?new Error("THREE.WebGLRenderer: Error creating WebGL context with your selected attributes."):new Error("THREE.WebGLRenderer: Error creating WebGL context.")}ne()}catch(w){throw e.removeEventListener("webglcontextlost",Vt,!1),e.removeEventListener("webglcontextrestored",ie,!1),e.removeEventListener("webglcontextcreationerror",It,!1),se("WebGLRenderer: "+w.message),w}function ne(){Qt=new Yb(k),Qt.init(),xt=new PT(k,Qt),he=new Ob(k,Qt,t,xt),Et=new CT(k,Qt),he.reversedDepthBuffer&&h&&Et.buffers.depth.setReversed(!0),O=k.createFramebuffer(),P=k.createFramebuffer(),G=k.createFramebuffer(),ze=new Kb(k),Wt=new pT,Kt=new RT(k,Qt,Et,Wt,he,xt,ze),I=new $b(N),M=new Qv(k),wt=new Ub(k,M),$=new Zb(k,M,ze,wt),ft=new Qb(k,$,M,wt,ze),ot=new jb(k,he,Kt),rt=new Bb(Wt),at=new dT(N,I,Qt,he,wt,rt),yt=new NT(N,Wt),St=new gT,nt=new MT(Qt),B=new Nb(N,I,Et,ft,p,l),gt=new AT(N,ft,he),qt=new UT(k,ze,he,Et),it=new Fb(k,Qt,ze),At=new Jb(k,Qt,ze),ze.programs=at.programs,N.capabilities=he,N.extensions=Qt,N.properties=Wt,N.renderLists=St,N.shadowMap=gt,N.state=Et,N.info=ze}_!==ai&&(U=new ew(_,e.width,e.height,a,s,r));let ut=new jf(N,k);this.xr=ut,this.getContext=function(){return k},this.getContextAttributes=function(){return k.getContextAttributes()},this.forceContextLoss=function(){let w=Qt.get("WEBGL_lose_context");w&&w.loseContext()},this.forceContextRestore=function(){let w=Qt.get("WEBGL_lose_context");w&&w.restoreContext()},this.getPixelRatio=function(){return Tt},this.setPixelRatio=function(w){w!==void 0&&(Tt=w,this.setSize(vt,Pt,!1))},this.getSize=function(w){return w.set(vt,Pt)},this.setSize=function(w,V,tt=!0){if(ut.isPresenting){jt("WebGLRenderer: Can't change size while VR device is presenting.");return}vt=w,Pt=V,e.width=Math.floor(w*Tt),e.height=Math.floor(V*Tt),tt===!0&&(e.style.width=w+"px",e.style.height=V+"px"),U!==null&&U.setSize(e.width,e.height),this.setViewport(0,0,w,V)},this.getDrawingBufferSize=function(w){return w.set(vt*Tt,Pt*Tt).floor()},this.setDrawingBufferSize=function(w,V,tt){vt=w,Pt=V,Tt=tt,e.width=Math.floor(w*tt),e.height=Math.floor(V*tt),this.setViewport(0,0,w,V)},this.setEffects=function(w){if(_===ai){se("WebGLRenderer: setEffects() requires outputBufferType set to HalfFloatType or FloatType.");return}if(w){for(let V=0;V<w.length;V++)if(w[V].isOutputPass===!0){jt("WebGLRenderer: OutputPass is not needed in setEffects(). Tone mapping and color space conversion are applied automatically.");break}}U.setEffects(w||[])},this.getCurrentViewport=function(w){return w.copy(st)},this.getViewport=function(w){return w.copy(Xt)},this.setViewport=function(w,V,tt,Z){w.isVector4?Xt.set(w.x,w.y,w.z,w.w):Xt.set(w,V,tt,Z),Et.viewport(st.copy(Xt).multiplyScalar(fn()).round())},this.getScissor=function(w){return w.copy(ge)},this.setScissor=function(w,V,tt,Z){w.isVector4?ge.set(w.x,w.y,w.z,w.w):ge.set(w,V,tt,Z),Et.scissor(pt.copy(ge).multiplyScalar(fn()).round())},this.getScissorTest=function(){return de},this.setScissorTest=function(w){Et.setScissorTest(de=w)},this.setOpaqueSort=function(w){Yt=w},this.setTransparentSort=function(w){ce=w},this.getClearColor=function(w){return w.copy(B.getClearColor())},this.setClearColor=function(){B.setClearColor(...arguments)},this.getClearAlpha=function(){return B.getClearAlpha()},this.setClearAlpha=function(){B.setClearAlpha(...arguments)},this.clear=function(w=!0,V=!0,tt=!0){let Z=0;if(w){let J=!1;if(ct!==null){let Ct=ct.texture.format;J=g.has(Ct)}if(J){let Ct=ct.texture.type,Dt=m.has(Ct),Rt=B.getClearColor(),Nt=B.getClearAlpha(),Ht=Rt.r,re=Rt.g,_e=Rt.b;Dt?(v[0]=Ht,v[1]=re,v[2]=_e,v[3]=Nt,k.clearBufferuiv(k.COLOR,0,v)):(A[0]=Ht,A[1]=re,A[2]=_e,A[3]=Nt,k.clearBufferiv(k.COLOR,0,A))}else Z|=k.COLOR_BUFFER_BIT}V&&(Z|=k.DEPTH_BUFFER_BIT,this.state.buffers.depth.setMask(!0)),tt&&(Z|=k.STENCIL_BUFFER_BIT,this.state.buffers.stencil.setMask(4294967295)),Z!==0&&k.clear(Z)},this.clearColor=function(){this.clear(!0,!1,!1)},this.clearDepth=function(){this.clear(!1,!0,!1)},this.clearStencil=function(){this.clear(!1,!1,!0)},this.setNodesHandler=function(w){w.setRenderer(this),z=w},this.dispose=function(){e.removeEventListener("webglcontextlost",Vt,!1),e.removeEventListener("webglcontextrestored",ie,!1),e.removeEventListener("webglcontextcreationerror",It,!1),B.dispose(),St.dispose(),nt.dispose(),Kt.dispose(),Wt.dispose(),I.dispose(),ft.dispose(),$.dispose(),wt.dispose(),qt.dispose(),at.dispose(),ut.dispose(),ut.removeEventListener("sessionstart",sl),ut.removeEventListener("sessionend",Xi),us.stop()};function Vt(w){w.preventDefault(),da("WebGLRenderer: Context Lost."),L=!0}function ie(){da("WebGLRenderer: Context Restored."),L=!1;let w=ze.autoReset,V=gt.enabled,tt=gt.autoUpdate,Z=gt.needsUpdate,J=gt.type;ne(),ze.autoReset=w,gt.enabled=V,gt.autoUpdate=tt,gt.needsUpdate=Z,gt.type=J}function It(w){se("WebGLRenderer: A WebGL context could not be created. Reason: ",w.statusMessage)}function fe(w){let V=w.target;V.removeEventListener("dispose",fe),Xe(V)}function Xe(w){Wn(w),Wt.remove(w)}function Wn(w){let V=Wt.get(w).programs;V!==void 0&&(V.forEach(function(tt){at.releaseProgram(tt)}),w.isShaderMaterial&&at.releaseShaderCache(w))}this.renderBufferDirect=function(w,V,tt,Z,J,Ct){V===null&&(V=yn);let Dt=J.isMesh&&J.matrixWorld.determinantAffine()<0,Rt=Ho(w,V,tt,Z,J);Et.setMaterial(Z,Dt);let Nt=tt.index,Ht=1;if(Z.wireframe===!0){if(Nt=$.getWireframeAttribute(tt),Nt===void 0)return;Ht=2}let re=tt.drawRange,_e=tt.attributes.position,Gt=re.start*Ht,xe=(re.start+re.count)*Ht;Ct!==null&&(Gt=Math.max(Gt,Ct.start*Ht),xe=Math.min(xe,(Ct.start+Ct.count)*Ht)),Nt!==null?(Gt=Math.max(Gt,0),xe=Math.min(xe,Nt.count)):_e!=null&&(Gt=Math.max(Gt,0),xe=Math.min(xe,_e.count));let tn=xe-Gt;if(tn<0||tn===1/0)return;wt.setup(J,Z,Rt,tt,Nt);let Ue,Fe=it;if(Nt!==null&&(Ue=M.get(Nt),Fe=At,Fe.setIndex(Ue)),J.isMesh)Z.wireframe===!0?(Et.setLineWidth(Z.wireframeLinewidth*fn()),Fe.setMode(k.LINES)):Fe.setMode(k.TRIANGLES);else if(J.isLine){let vn=Z.linewidth;vn===void 0&&(vn=1),Et.setLineWidth(vn*fn()),J.isLineSegments?Fe.setMode(k.LINES):J.isLineLoop?Fe.setMode(k.LINE_LOOP):Fe.setMode(k.LINE_STRIP)}else J.isPoints?Fe.setMode(k.POINTS):J.isSprite&&Fe.setMode(k.TRIANGLES);if(J.isBatchedMesh)if(Qt.get("WEBGL_multi_draw"))Fe.renderMultiDraw(J._multiDrawStarts,J._multiDrawCounts,J._multiDrawCount);else{let vn=J._multiDrawStarts,Bt=J._multiDrawCounts,dn=J._multiDrawCount,Se=Nt?M.get(Nt).bytesPerElement:1,ds=Wt.get(Z).currentProgram.getUniforms();for(let pn=0;pn<dn;pn++)ds.setValue(k,"_gl_DrawID",pn),Fe.render(vn[pn]/Se,Bt[pn])}else if(J.isInstancedMesh)Fe.renderInstances(Gt,tn,J.count);else if(tt.isInstancedBufferGeometry){let vn=tt._maxInstanceCount!==void 0?tt._maxInstanceCount:1/0,Bt=Math.min(tt.instanceCount,vn);Fe.renderInstances(Gt,tn,Bt)}else Fe.render(Gt,tn)};function zo(w,V,tt,Z){z!==null&&w.isNodeMaterial&&z.setObject(Z,w),He===!0&&rt.setState(w,tt,!1),w.transparent===!0&&w.side===oi&&w.forceSinglePass===!1?(w.side=ei,w.needsUpdate=!0,qi(w,V,Z),w.side=js,w.needsUpdate=!0,qi(w,V,Z),w.side=oi):qi(w,V,Z)}this.compile=function(w,V,tt=null){tt===null&&(tt=w),z!==null&&z.renderStart(w,V,tt),E=nt.get(tt),E.init(V),T.push(E),tt.traverseVisible(function(J){J.isLight&&J.layers.test(V.layers)&&(E.pushLight(J),J.castShadow&&E.pushShadow(J))}),w!==tt&&w.traverseVisible(function(J){J.isLight&&J.layers.test(V.layers)&&(E.pushLight(J),J.castShadow&&E.pushShadow(J))}),E.setupLights(),z!==null&&z.updateLights(E.state.lightsArray),un=this.localClippingEnabled,He=rt.init(this.clippingPlanes,un),He===!0&&rt.setGlobalState(this.clippingPlanes,V),z!==null&&gt.render(E.state.shadowsArray,tt,V);let Z=new Set;return w.traverse(function(J){if(!(J.isMesh||J.isPoints||J.isLine||J.isSprite))return;let Ct=J.material;if(Ct)if(Array.isArray(Ct))for(let Dt=0;Dt<Ct.length;Dt++){let Rt=Ct[Dt];zo(Rt,tt,V,J),Z.add(Rt)}else zo(Ct,tt,V,J),Z.add(Ct)}),E=T.pop(),z!==null&&z.renderEnd(),Z},this.compileAsync=function(w,V,tt=null){let Z=this.compile(w,V,tt);return new Promise(J=>{function Ct(){if(Z.forEach(function(Dt){let Nt=Wt.get(Dt).currentProgram;(Nt===void 0||Nt.isReady())&&Z.delete(Dt)}),Z.size===0){J(w);return}setTimeout(Ct,10)}Qt.get("KHR_parallel_shader_compile")!==null?Ct():setTimeout(Ct,10)})};let Pr=null;function du(w){Pr&&Pr(w)}function sl(){us.stop()}function Xi(){us.start()}let us=new Jg;us.setAnimationLoop(du),typeof self<"u"&&us.setContext(self),this.setAnimationLoop=function(w){Pr=w,ut.setAnimationLoop(w),w===null?us.stop():us.start()},ut.addEventListener("sessionstart",sl),ut.addEventListener("sessionend",Xi),this.render=function(w,V){if(V!==void 0&&V.isCamera!==!0){se("WebGLRenderer.render: camera is not an instance of THREE.Camera.");return}if(L===!0)return;z!==null&&z.renderStart(w,V);let tt=ut.enabled===!0&&ut.isPresenting===!0,Z=U!==null&&(ct===null||tt)&&U.begin(N,ct);if(w.matrixWorldAutoUpdate===!0&&w.updateMatrixWorld(),V.parent===null&&V.matrixWorldAutoUpdate===!0&&V.updateMatrixWorld(),ut.enabled===!0&&ut.isPresenting===!0&&(U===null||U.isCompositing()===!1)&&(ut.cameraAutoUpdate===!0&&ut.updateCamera(V),V=ut.getCamera()),w.isScene===!0&&w.onBeforeRender(N,w,V,ct),E=nt.get(w,T.length),E.init(V),E.state.textureUnits=Kt.getTextureUnits(),T.push(E),Be.multiplyMatrices(V.projectionMatrix,V.matrixWorldInverse),V.isArrayCamera?Ke.setFromArrayCamera(V):ae.setFromProjectionMatrix(Be,Ti,V.reversedDepth),un=this.localClippingEnabled,He=rt.init(this.clippingPlanes,un),R=St.get(w,x.length),R.init(),x.push(R),this.info.render.frame++,ut.enabled===!0&&ut.isPresenting===!0){let Dt=N.xr.getDepthSensingMesh();Dt!==null&&fs(Dt,V,-1/0,N.sortObjects)}fs(w,V,0,N.sortObjects),R.finish(),z!==null&&z.updateLights(E.state.lightsArray),N.sortObjects===!0&&R.sort(Yt,ce),en=ut.enabled===!1||ut.isPresenting===!1||ut.hasDepthSensing()===!1,en&&B.addToRenderList(R,w),this.info.autoReset===!0&&this.info.reset(),He===!0&&rt.beginShadows();let J=E.state.shadowsArray;if(gt.render(J,w,V),He===!0&&rt.endShadows(),(Z&&U.hasRenderPass())===!1){let Dt=R.opaque,Rt=R.transmissive;if(E.setupLights(),V.isArrayCamera){let Nt=V.cameras;if(Rt.length>0)for(let Ht=0,re=Nt.length;Ht<re;Ht++){let _e=Nt[Ht];Ri(Dt,Rt,w,_e)}en&&B.render(w);for(let Ht=0,re=Nt.length;Ht<re;Ht++){let _e=Nt[Ht];Vo(R,w,_e,_e.viewport)}}else Rt.length>0&&Ri(Dt,Rt,w,V),en&&B.render(w),Vo(R,w,V)}ct!==null&&H===0&&(Kt.updateMultisampleRenderTarget(ct),Kt.updateRenderTargetMipmap(ct)),Z&&U.end(N),w.isScene===!0&&w.onAfterRender(N,w,V),wt.resetDefaultState(),K=-1,et=null,T.pop(),T.length>0?(E=T[T.length-1],Kt.setTextureUnits(E.state.textureUnits),He===!0&&rt.setGlobalState(N.clippingPlanes,E.state.camera)):E=null,x.pop(),x.length>0?R=x[x.length-1]:R=null,z!==null&&z.renderEnd()};function fs(w,V,tt,Z){if(w.visible===!1)return;if(w.layers.test(V.layers)){if(w.isGroup)tt=w.renderOrder;else if(w.isLOD)w.autoUpdate===!0&&w.update(V);else if(w.isLight)E.pushLight(w),w.castShadow&&E.pushShadow(w);else if(w.isSprite){let Dt=V.isArrayCamera?Ke:ae;if(!w.frustumCulled||w.intersectsFrustum(Dt)){Z&&we.setFromMatrixPosition(w.matrixWorld).applyMatrix4(Be);let Rt=ft.update(w),Nt=w.material;Nt.visible&&R.push(w,Rt,Nt,tt,we.z,null,V)}}else if(w.isMesh||w.isLine||w.isPoints){let Dt=V.isArrayCamera?Ke:ae;if(!w.frustumCulled||w.intersectsFrustum(Dt)){let Rt=ft.update(w),Nt=w.material;if(Z&&(w.boundingSphere!==void 0?(w.boundingSphere===null&&w.computeBoundingSphere(),we.copy(w.boundingSphere.center)):(Rt.boundingSphere===null&&Rt.computeBoundingSphere(),we.copy(Rt.boundingSphere.center)),we.applyMatrix4(w.matrixWorld).applyMatrix4(Be)),Array.isArray(Nt)){let Ht=Rt.groups;for(let re=0,_e=Ht.length;re<_e;re++){let Gt=Ht[re],xe=Nt[Gt.materialIndex];xe&&xe.visible&&R.push(w,Rt,xe,tt,we.z,Gt,V)}}else Nt.visible&&R.push(w,Rt,Nt,tt,we.z,null,V)}}}let Ct=w.children;for(let Dt=0,Rt=Ct.length;Dt<Rt;Dt++)fs(Ct[Dt],V,tt,Z)}function Vo(w,V,tt,Z){let{opaque:J,transmissive:Ct,transparent:Dt}=w;E.setupLightsView(tt),He===!0&&rt.setGlobalState(N.clippingPlanes,tt),Z&&Et.viewport(st.copy(Z)),J.length>0&&nn(J,V,tt),Ct.length>0&&nn(Ct,V,tt),Dt.length>0&&nn(Dt,V,tt),Et.buffers.depth.setTest(!0),Et.buffers.depth.setMask(!0),Et.buffers.color.setMask(!0),Et.setPolygonOffset(!1)}function Ri(w,V,tt,Z){if((tt.isScene===!0?tt.overrideMaterial:null)!==null)return;if(E.state.transmissionRenderTarget[Z.id]===void 0){let Gt=Qt.has("EXT_color_buffer_half_float")||Qt.has("EXT_color_buffer_float");E.state.transmissionRenderTarget[Z.id]=new gi(1,1,{generateMipmaps:!0,type:Gt?zi:ai,minFilter:Es,samples:Math.max(4,he.samples),stencilBuffer:r,resolveDepthBuffer:!1,resolveStencilBuffer:!1,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,colorSpace:Me.workingColorSpace})}let Ct=E.state.transmissionRenderTarget[Z.id],Dt=Z.viewport||st;Ct.setSize(Dt.z*N.transmissionResolutionScale,Dt.w*N.transmissionResolutionScale);let Rt=N.getRenderTarget(),Nt=N.getActiveCubeFace(),Ht=N.getActiveMipmapLevel();N.setRenderTarget(Ct),N.getClearColor(Q),_t=N.getClearAlpha(),_t<1&&N.setClearColor(16777215,.5),N.clear(),en&&B.render(tt);let re=N.toneMapping;N.toneMapping=as;let _e=Z.viewport;if(Z.viewport!==void 0&&(Z.viewport=void 0),E.setupLightsView(Z),He===!0&&rt.setGlobalState(N.clippingPlanes,Z),nn(w,tt,Z),Kt.updateMultisampleRenderTarget(Ct),Kt.updateRenderTargetMipmap(Ct),Qt.has("WEBGL_multisampled_render_to_texture")===!1){let Gt=!1;for(let xe=0,tn=V.length;xe<tn;xe++){let Ue=V[xe],{object:Fe,geometry:vn,material:Bt,group:dn}=Ue;if(Bt.side===oi&&Fe.layers.test(Z.layers)){let Se=Bt.side;Bt.side=ei,Bt.needsUpdate=!0,cn(Fe,tt,Z,vn,Bt,dn),Bt.side=Se,Bt.needsUpdate=!0,Gt=!0}}Gt===!0&&(Kt.updateMultisampleRenderTarget(Ct),Kt.updateRenderTargetMipmap(Ct))}N.setRenderTarget(Rt,Nt,Ht),N.setClearColor(Q,_t),_e!==void 0&&(Z.viewport=_e),N.toneMapping=re}function nn(w,V,tt){let Z=V.isScene===!0?V.overrideMaterial:null;for(let J=0,Ct=w.length;J<Ct;J++){let Dt=w[J],{object:Rt,geometry:Nt,group:Ht}=Dt,re=Dt.material;re.allowOverride===!0&&Z!==null&&(re=Z),Rt.layers.test(tt.layers)&&cn(Rt,V,tt,Nt,re,Ht)}}function cn(w,V,tt,Z,J,Ct){z!==null&&J.isNodeMaterial&&z.setObject(w,J),w.onBeforeRender(N,V,tt,Z,J,Ct),w.modelViewMatrix.multiplyMatrices(tt.matrixWorldInverse,w.matrixWorld),w.normalMatrix.getNormalMatrix(w.modelViewMatrix),J.onBeforeRender(N,V,tt,Z,w,Ct),J.transparent===!0&&J.side===oi&&J.forceSinglePass===!1?(J.side=ei,J.needsUpdate=!0,N.renderBufferDirect(tt,V,Z,J,w,Ct),J.side=js,J.needsUpdate=!0,N.renderBufferDirect(tt,V,Z,J,w,Ct),J.side=oi):N.renderBufferDirect(tt,V,Z,J,w,Ct),w.onAfterRender(N,V,tt,Z,J,Ct)}function hn(w){let V=0;for(let tt of w)tt.texture!==null&&V++;return V}function qi(w,V,tt){V.isScene!==!0&&(V=yn);let Z=Wt.get(w),J=E.state.lights,Ct=E.state.shadowsArray,Dt=J.state.version,Rt=at.getParameters(w,J.state,Ct,V,tt,E.state.lightProbeGridArray),Nt=at.getProgramCacheKey(Rt),Ht=Z.programs;Z.environment=w.isMeshStandardMaterial||w.isMeshLambertMaterial||w.isMeshPhongMaterial?V.environment:null,Z.fog=V.fog;let re=w.isMeshStandardMaterial||w.isMeshLambertMaterial&&!w.envMap||w.isMeshPhongMaterial&&!w.envMap;Z.envMap=I.get(w.envMap||Z.environment,re),Z.envMapRotation=Z.environment!==null&&w.envMap===null?V.environmentRotation:w.envMapRotation,Ht===void 0&&(w.addEventListener("dispose",fe),Ht=new Map,Z.programs=Ht,Z.programVariants=new Map);let _e=Ht.get(Nt);if(_e!==void 0){if(Z.currentProgram===_e&&Z.lightsStateVersion===Dt)return Go(w,Rt),_e}else Rt.uniforms=at.getUniforms(w),z!==null&&w.isNodeMaterial&&z.build(w,tt,Rt),w.onBeforeCompile(Rt,N),_e=at.acquireProgram(Rt,Nt),Ht.set(Nt,_e),Z.uniforms=Rt.uniforms;let Gt=Z.uniforms;return(!w.isShaderMaterial&&!w.isRawShaderMaterial||w.clipping===!0)&&(Gt.clippingPlanes=rt.uniform),Go(w,Rt),Z.needsLights=Us(w),Z.lightsStateVersion=Dt,Z.needsLights&&(Gt.ambientLightColor.value=J.state.ambient,Gt.lightProbe.value=J.state.probe,Gt.sunLights.value=J.state.sun,Gt.sunLightShadows.value=J.state.sunShadow,Gt.directionalLights.value=J.state.directional,Gt.directionalLightShadows.value=J.state.directionalShadow,Gt.spotLights.value=J.state.spot,Gt.spotLightShadows.value=J.state.spotShadow,Gt.rectAreaLights.value=J.state.rectArea,Gt.ltc_1.value=J.state.rectAreaLTC1,Gt.ltc_2.value=J.state.rectAreaLTC2,Gt.pointLights.value=J.state.point,Gt.pointLightShadows.value=J.state.pointShadow,Gt.hemisphereLights.value=J.state.hemi,Gt.sunShadowMatrix.value=J.state.sunShadowMatrix,Gt.sunShadowCascade.value=J.state.sunShadowCascade,Gt.directionalShadowMatrix.value=J.state.directionalShadowMatrix,Gt.spotLightMatrix.value=J.state.spotLightMatrix,Gt.spotLightMap.value=J.state.spotLightMap,Gt.pointShadowMatrix.value=J.state.pointShadowMatrix),Z.numLightProbeGrids=hn(E.state.lightProbeGridArray),Z.currentProgram=_e,Z.uniformsList=null,_e}function ci(w,V,tt,Z,J){let Ct=Wt.get(w),Dt=Ct.currentProgram.id+","+Z+","+J,Rt=Ct.programVariants.get(Dt);return Rt===void 0?(Rt=qi(w,V,tt),Ct.programVariants.set(Dt,Rt)):(Ct.currentProgram=Rt,Ct.uniformsList=null,Ct.outputColorSpace=Z,Ct.toneMapping=J),Rt}function Ns(w){if(w.uniformsList===null){let V=w.currentProgram.getUniforms();w.uniformsList=Ao.seqWithValue(V.seq,w.uniforms)}return w.uniformsList}function Go(w,V){let tt=Wt.get(w);tt.outputColorSpace=V.outputColorSpace,tt.batching=V.batching,tt.batchingColor=V.batchingColor,tt.instancing=V.instancing,tt.instancingColor=V.instancingColor,tt.instancingMorph=V.instancingMorph,tt.skinning=V.skinning,tt.morphTargets=V.morphTargets,tt.morphNormals=V.morphNormals,tt.morphColors=V.morphColors,tt.morphTargetsCount=V.morphTargetsCount,tt.numClippingPlanes=V.numClippingPlanes,tt.numIntersection=V.numClipIntersection,tt.vertexAlphas=V.vertexAlphas,tt.vertexTangents=V.vertexTangents,tt.toneMapping=V.toneMapping}function Ho(w,V,tt,Z,J){V.isScene!==!0&&(V=yn),Kt.resetTextureUnits();let Ct=V.fog,Dt=Z.isMeshStandardMaterial||Z.isMeshLambertMaterial||Z.isMeshPhongMaterial?V.environment:null,Rt=ct===null?N.outputColorSpace:ct.isXRRenderTarget===!0?ct.texture.colorSpace:Me.workingColorSpace,Nt=Z.isMeshStandardMaterial||Z.isMeshLambertMaterial&&!Z.envMap||Z.isMeshPhongMaterial&&!Z.envMap,Ht=I.get(Z.envMap||Dt,Nt),re=Z.vertexColors===!0&&!!tt.attributes.color&&tt.attributes.color.itemSize===4,_e=!!tt.attributes.tangent&&(!!Z.normalMap||Z.anisotropy>0),Gt=!!tt.morphAttributes.position,xe=!!tt.morphAttributes.normal,tn=!!tt.morphAttributes.color,Ue=as;Z.toneMapped&&(ct===null||ct.isXRRenderTarget===!0)&&(Ue=N.toneMapping);let Fe=tt.morphAttributes.position||tt.morphAttributes.normal||tt.morphAttributes.color,vn=Fe!==void 0?Fe.length:0,Bt=Wt.get(Z),dn=E.state.lights;if(He===!0&&(un===!0||w!==et)){let Oe=w===et&&Z.id===K;rt.setState(Z,w,Oe)}let Se=!1,ds=!1;Z.version===Bt.__version?Bt.needsLights&&Bt.lightsStateVersion!==dn.state.version||J.isBatchedMesh&&Bt.batching===!1||!J.isBatchedMesh&&Bt.batching===!0||J.isBatchedMesh&&Bt.batchingColor===!0&&J._colorsTexture===null||J.isBatchedMesh&&Bt.batchingColor===!1&&J._colorsTexture!==null||J.isInstancedMesh&&Bt.instancing===!1||!J.isInstancedMesh&&Bt.instancing===!0||J.isSkinnedMesh&&Bt.skinning===!1||!J.isSkinnedMesh&&Bt.skinning===!0||J.isInstancedMesh&&Bt.instancingColor===!0&&J.instanceColor===null||J.isInstancedMesh&&Bt.instancingColor===!1&&J.instanceColor!==null||J.isInstancedMesh&&Bt.instancingMorph===!0&&J.morphTexture===null||J.isInstancedMesh&&Bt.instancingMorph===!1&&J.morphTexture!==null||Bt.envMap!==Ht||Z.fog===!0&&Bt.fog!==Ct||Bt.numClippingPlanes!==void 0&&(Bt.numClippingPlanes!==rt.numPlanes||Bt.numIntersection!==rt.numIntersection)||Bt.vertexAlphas!==re||Bt.vertexTangents!==_e||Bt.morphTargets!==Gt||Bt.morphNormals!==xe||Bt.morphColors!==tn||Bt.morphTargetsCount!==vn||Bt.numLightProbeGrids!==hn(E.state.lightProbeGridArray)?Se=!0:(Bt.outputColorSpace!==Rt||Bt.toneMapping!==Ue)&&(ds=!0):(Se=!0,Bt.__version=Z.version);let pn=Bt.currentProgram;(Se===!0||ds===!0)&&(pn=ds===!0?ci(Z,V,J,Rt,Ue):qi(Z,V,J),z&&Z.isNodeMaterial&&z.onUpdateProgram(Z,pn,Bt));let Dr=!1,$i=!1,ps=!1,pe=pn.getUniforms(),sn=Bt.uniforms;if(Et.useProgram(pn.program)&&(Dr=!0,$i=!0,ps=!0),Z.id!==K&&(K=Z.id,$i=!0),Dr||et!==w){Et.buffers.depth.getReversed()&&w.reversedDepth!==!0&&(w._reversedDepth=!0,w.updateProjectionMatrix()),pe.setValue(k,"projectionMatrix",w.projectionMatrix),pe.setValue(k,"viewMatrix",w.matrixWorldInverse);let mn=pe.map.cameraPosition;mn!==void 0&&mn.setValue(k,Rn.setFromMatrixPosition(w.matrixWorld)),he.logarithmicDepthBuffer&&pe.setValue(k,"logDepthBufFC",2/(Math.log(w.far+1)/Math.LN2)),(Z.isMeshPhongMaterial||Z.isMeshToonMaterial||Z.isMeshLambertMaterial||Z.isMeshBasicMaterial||Z.isMeshStandardMaterial||Z.isShaderMaterial)&&pe.setValue(k,"isOrthographic",w.isOrthographicCamera===!0),et!==w&&(et=w,$i=!0,ps=!0)}if(Bt.needsLights&&(dn.state.sunShadowMap.length>0&&pe.setValue(k,"sunShadowMap",dn.state.sunShadowMap,Kt),dn.state.directionalShadowMap.length>0&&pe.setValue(k,"directionalShadowMap",dn.state.directionalShadowMap,Kt),dn.state.spotShadowMap.length>0&&pe.setValue(k,"spotShadowMap",dn.state.spotShadowMap,Kt),dn.state.pointShadowMap.length>0&&pe.setValue(k,"pointShadowMap",dn.state.pointShadowMap,Kt)),J.isSkinnedMesh){pe.setOptional(k,J,"bindMatrix"),pe.setOptional(k,J,"bindMatrixInverse");let Oe=J.skeleton;Oe&&(Oe.boneTexture===null&&Oe.computeBoneTexture(),pe.setValue(k,"boneTexture",Oe.boneTexture,Kt))}J.isBatchedMesh&&(pe.setOptional(k,J,"batchingTexture"),pe.setValue(k,"batchingTexture",J._matricesTexture,Kt),pe.setOptional(k,J,"batchingIdTexture"),pe.setValue(k,"batchingIdTexture",J._indirectTexture,Kt),pe.setOptional(k,J,"batchingColorTexture"),J._colorsTexture!==null&&pe.setValue(k,"batchingColorTexture",J._colorsTexture,Kt));let Xn=tt.morphAttributes;if((Xn.position!==void 0||Xn.normal!==void 0||Xn.color!==void 0)&&ot.update(J,tt,pn),($i||Bt.receiveShadow!==J.receiveShadow)&&(Bt.receiveShadow=J.receiveShadow,pe.setValue(k,"receiveShadow",J.receiveShadow)),(Z.isMeshStandardMaterial||Z.isMeshLambertMaterial||Z.isMeshPhongMaterial)&&Z.envMap===null&&V.environment!==null&&(sn.envMapIntensity.value=V.environmentIntensity),sn.dfgLUT!==void 0&&(sn.dfgLUT.value=OT()),$i){if(pe.setValue(k,"toneMappingExposure",N.toneMappingExposure),Bt.needsLights&&Ir(sn,ps),Ct&&Z.fog===!0&&yt.refreshFogUniforms(sn,Ct),yt.refreshMaterialUniforms(sn,Z,Tt,Pt,E.state.transmissionRenderTarget[w.id]),Bt.needsLights&&Bt.numLightProbeGrids>0){let Oe=S,mn=0;for(let zn of E.state.lightProbeGridArray)zn.texture!==null&&(Oe.textures[mn]=zn.texture,Oe.min[mn]=zn.boundingBox.min,Oe.max[mn]=zn.boundingBox.max,Oe.resolution[mn]=zn.resolution,mn++);for(let zn in Oe)Oe[zn].length=mn;sn.probesSH.value=Oe.textures,sn.probesMin.value=Oe.min,sn.probesMax.value=Oe.max,sn.probesResolution.value=Oe.resolution}Ao.upload(k,Ns(Bt),sn,Kt)}if(Z.isShaderMaterial&&Z.uniformsNeedUpdate===!0&&(Ao.upload(k,Ns(Bt),sn,Kt),Z.uniformsNeedUpdate=!1),Z.isSpriteMaterial&&pe.setValue(k,"center",J.center),pe.setValue(k,"modelViewMatrix",J.modelViewMatrix),pe.setValue(k,"normalMatrix",J.normalMatrix),pe.setValue(k,"modelMatrix",J.matrixWorld),Z.uniformsGroups!==void 0){let Oe=Z.uniformsGroups;for(let mn=0,zn=Oe.length;mn<zn;mn++){let rl=Oe[mn];qt.update(rl,pn),qt.bind(rl,pn)}}return pn}function Ir(w,V){w.ambientLightColor.needsUpdate=V,w.lightProbe.needsUpdate=V,w.sunLights.needsUpdate=V,w.sunLightShadows.needsUpdate=V,w.directionalLights.needsUpdate=V,w.directionalLightShadows.needsUpdate=V,w.pointLights.needsUpdate=V,w.pointLightShadows.needsUpdate=V,w.spotLights.needsUpdate=V,w.spotLightShadows.needsUpdate=V,w.rectAreaLights.needsUpdate=V,w.hemisphereLights.needsUpdate=V}function Us(w){return w.isMeshLambertMaterial||w.isMeshToonMaterial||w.isMeshPhongMaterial||w.isMeshStandardMaterial||w.isShadowMaterial||w.isShaderMaterial&&w.lights===!0}this.getActiveCubeFace=function(){return q},this.getActiveMipmapLevel=function(){return H},this.getRenderTarget=function(){return ct},this.setRenderTargetTextures=function(w,V,tt){let Z=Wt.get(w);Z.__autoAllocateDepthBuffer=w.resolveDepthBuffer===!1,Z.__autoAllocateDepthBuffer===!1&&(Z.__useRenderToTexture=!1),Wt.get(w.texture).__webglTexture=V,Wt.get(w.depthTexture).__webglTexture=Z.__autoAllocateDepthBuffer?void 0:tt,Z.__hasExternalTextures=!0},this.setRenderTargetFramebuffer=function(w,V){let tt=Wt.get(w);tt.__webglFramebuffer=V,tt.__useDefaultFramebuffer=V===void 0},this.setRenderTarget=function(w,V=0,tt=0){ct=w,q=V,H=tt;let Z=null,J=!1,Ct=!1;if(w){let Rt=Wt.get(w);if(Rt.__useDefaultFramebuffer!==void 0){Et.bindFramebuffer(k.FRAMEBUFFER,Rt.__webglFramebuffer),st.copy(w.viewport),pt.copy(w.scissor),dt=w.scissorTest,Et.viewport(st),Et.scissor(pt),Et.setScissorTest(dt),K=-1;return}else if(Rt.__webglFramebuffer===void 0)Kt.setupRenderTarget(w);else if(Rt.__hasExternalTextures)Kt.rebindTextures(w,Wt.get(w.texture).__webglTexture,Wt.get(w.depthTexture).__webglTexture);else if(w.depthBuffer){let re=w.depthTexture;if(Rt.__boundDepthTexture!==re){if(re!==null&&Wt.has(re)&&(w.width!==re.image.width||w.height!==re.image.height))throw new Error("THREE.WebGLRenderer: Attached DepthTexture is initialized to the incorrect size.");Kt.setupDepthRenderbuffer(w)}}let Nt=w.texture;(Nt.isData3DTexture||Nt.isDataArrayTexture||Nt.isCompressedArrayTexture)&&(Ct=!0);let Ht=Wt.get(w).__webglFramebuffer;w.isWebGLCubeRenderTarget?(Array.isArray(Ht[V])?Z=Ht[V][tt]:Z=Ht[V],J=!0):w.samples>0&&Kt.useMultisampledRTT(w)===!1?Z=Wt.get(w).__webglMultisampledFramebuffer:Array.isArray(Ht)?Z=Ht[tt]:Z=Ht,st.copy(w.viewport),pt.copy(w.scissor),dt=w.scissorTest}else st.copy(Xt).multiplyScalar(Tt).floor(),pt.copy(ge).multiplyScalar(Tt).floor(),dt=de;if(tt!==0&&(Z=O),Et.bindFramebuffer(k.FRAMEBUFFER,Z)&&Et.drawBuffers(w,Z),Et.viewport(st),Et.scissor(pt),Et.setScissorTest(dt),J){let Rt=Wt.get(w.texture);k.framebufferTexture2D(k.FRAMEBUFFER,k.COLOR_ATTACHMENT0,k.TEXTURE_CUBE_MAP_POSITIVE_X+V,Rt.__webglTexture,tt)}else if(Ct){let Rt=V;for(let Nt=0;Nt<w.textures.length;Nt++){let Ht=Wt.get(w.textures[Nt]);k.framebufferTextureLayer(k.FRAMEBUFFER,k.COLOR_ATTACHMENT0+Nt,Ht.__webglTexture,tt,Rt)}}else if(w!==null&&tt!==0){let Rt=Wt.get(w.texture);k.framebufferTexture2D(k.FRAMEBUFFER,k.COLOR_ATTACHMENT0,k.TEXTURE_2D,Rt.__webglTexture,tt)}K=-1};function Lr(w){let V=Wt.get(w);return(V.__readFormat!==w.format||V.__readType!==w.type)&&(V.__readFormat=w.format,V.__readType=w.type,V.__formatReadable=he.textureFormatReadable(w.format),V.__typeReadable=he.textureTypeReadable(w.type)),V}this.readRenderTargetPixels=function(w,V,tt,Z,J,Ct,Dt,Rt=0){if(!(w&&w.isWebGLRenderTarget)){se("WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");return}let Nt=Wt.get(w).__webglFramebuffer;if(w.isWebGLCubeRenderTarget&&Dt!==void 0&&(Nt=Nt[Dt],Array.isArray(Nt)&&(Nt=Nt[0])),Nt){Et.bindFramebuffer(k.FRAMEBUFFER,Nt);try{let Ht=w.textures[Rt],re=Ht.format,_e=Ht.type;w.textures.length>1&&k.readBuffer(k.COLOR_ATTACHMENT0+Rt);let Gt=Lr(Ht);if(Gt.__formatReadable===!1){se("WebGLRenderer.readRenderTargetPixels: renderTarget is not in RGBA or implementation defined format.");return}if(Gt.__typeReadable===!1){se("WebGLRenderer.readRenderTargetPixels: renderTarget is not in UnsignedByteType or implementation defined type.");return}V>=0&&V<=w.width-Z&&tt>=0&&tt<=w.height-J&&k.readPixels(V,tt,Z,J,xt.convert(re),xt.convert(_e),Ct)}finally{let Ht=ct!==null?Wt.get(ct).__webglFramebuffer:null;Et.bindFramebuffer(k.FRAMEBUFFER,Ht)}}},this.readRenderTargetPixelsAsync=async function(w,V,tt,Z,J,Ct,Dt,Rt=0){if(!(w&&w.isWebGLRenderTarget))throw new Error("THREE.WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");let Nt=Wt.get(w).__webglFramebuffer;if(w.isWebGLCubeRenderTarget&&Dt!==void 0&&(Nt=Nt[Dt],Array.isArray(Nt)&&(Nt=Nt[0])),Nt)if(V>=0&&V<=w.width-Z&&tt>=0&&tt<=w.height-J){Et.bindFramebuffer(k.FRAMEBUFFER,Nt);let Ht=w.textures[Rt],re=Ht.format,_e=Ht.type;w.textures.length>1&&k.readBuffer(k.COLOR_ATTACHMENT0+Rt);let Gt=Lr(Ht);if(Gt.__formatReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in RGBA or implementation defined format.");if(Gt.__typeReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in UnsignedByteType or implementation defined type.");let xe=k.createBuffer();k.bindBuffer(k.PIXEL_PACK_BUFFER,xe),k.bufferData(k.PIXEL_PACK_BUFFER,Ct.byteLength,k.STREAM_READ),k.readPixels(V,tt,Z,J,xt.convert(re),xt.convert(_e),0),k.bindBuffer(k.PIXEL_PACK_BUFFER,null);let tn=ct!==null?Wt.get(ct).__webglFramebuffer:null;Et.bindFramebuffer(k.FRAMEBUFFER,tn);let Ue=k.fenceSync(k.SYNC_GPU_COMMANDS_COMPLETE,0);return k.flush(),await Mg(k,Ue,4),k.bindBuffer(k.PIXEL_PACK_BUFFER,xe),k.getBufferSubData(k.PIXEL_PACK_BUFFER,0,Ct),k.bindBuffer(k.PIXEL_PACK_BUFFER,null),k.deleteBuffer(xe),k.deleteSync(Ue),Ct}else throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: requested read bounds are out of range.")},this.copyFramebufferToTexture=function(w,V=null,tt=0){let Z=Math.pow(2,-tt),J=Math.floor(w.image.width*Z),Ct=Math.floor(w.image.height*Z),Dt=V!==null?V.x:0,Rt=V!==null?V.y:0;Kt.setTexture2D(w,0),k.copyTexSubImage2D(k.TEXTURE_2D,tt,0,0,Dt,Rt,J,Ct),Et.unbindTexture()},this.copyTextureToTexture=function(w,V,tt=null,Z=null,J=0,Ct=0){let Dt,Rt,Nt,Ht,re,_e,Gt,xe,tn,Ue=w.isCompressedTexture?w.mipmaps[Ct]:w.image;if(tt!==null)Dt=tt.max.x-tt.min.x,Rt=tt.max.y-tt.min.y,Nt=tt.isBox3?tt.max.z-tt.min.z:1,Ht=tt.min.x,re=tt.min.y,_e=tt.isBox3?tt.min.z:0;else{let pe=Math.pow(2,-J);Dt=Math.floor(Ue.width*pe),Rt=Math.floor(Ue.height*pe),w.isDataArrayTexture?Nt=Ue.depth:w.isData3DTexture?Nt=Math.floor(Ue.depth*pe):Nt=1,Ht=0,re=0,_e=0}Z!==null?(Gt=Z.x,xe=Z.y,tn=Z.z):(Gt=0,xe=0,tn=0);let Fe=xt.convert(V.format),vn=xt.convert(V.type),Bt;V.isData3DTexture?(Kt.setTexture3D(V,0),Bt=k.TEXTURE_3D):V.isDataArrayTexture||V.isCompressedArrayTexture?(Kt.setTexture2DArray(V,0),Bt=k.TEXTURE_2D_ARRAY):(Kt.setTexture2D(V,0),Bt=k.TEXTURE_2D),Et.activeTexture(k.TEXTURE0),Et.pixelStorei(k.UNPACK_FLIP_Y_WEBGL,V.flipY),Et.pixelStorei(k.UNPACK_PREMULTIPLY_ALPHA_WEBGL,V.premultiplyAlpha),Et.pixelStorei(k.UNPACK_ALIGNMENT,V.unpackAlignment);let dn=Et.getParameter(k.UNPACK_ROW_LENGTH),Se=Et.getParameter(k.UNPACK_IMAGE_HEIGHT),ds=Et.getParameter(k.UNPACK_SKIP_PIXELS),pn=Et.getParameter(k.UNPACK_SKIP_ROWS),Dr=Et.getParameter(k.UNPACK_SKIP_IMAGES);Et.pixelStorei(k.UNPACK_ROW_LENGTH,Ue.width),Et.pixelStorei(k.UNPACK_IMAGE_HEIGHT,Ue.height),Et.pixelStorei(k.UNPACK_SKIP_PIXELS,Ht),Et.pixelStorei(k.UNPACK_SKIP_ROWS,re),Et.pixelStorei(k.UNPACK_SKIP_IMAGES,_e);let $i=w.isDataArrayTexture||w.isData3DTexture,ps=V.isDataArrayTexture||V.isData3DTexture;if(w.isDepthTexture){let pe=Wt.get(w),sn=Wt.get(V),Xn=Wt.get(pe.__renderTarget),Oe=Wt.get(sn.__renderTarget);Et.bindFramebuffer(k.READ_FRAMEBUFFER,Xn.__webglFramebuffer),Et.bindFramebuffer(k.DRAW_FRAMEBUFFER,Oe.__webglFramebuffer);for(let mn=0;mn<Nt;mn++)$i&&(k.framebufferTextureLayer(k.READ_FRAMEBUFFER,k.COLOR_ATTACHMENT0,Wt.get(w).__webglTexture,J,_e+mn),k.framebufferTextureLayer(k.DRAW_FRAMEBUFFER,k.COLOR_ATTACHMENT0,Wt.get(V).__webglTexture,Ct,tn+mn)),k.blitFramebuffer(Ht,re,Ht+Dt,re+Rt,Gt,xe,Gt+Dt,xe+Rt,k.DEPTH_BUFFER_BIT,k.NEAREST);Et.bindFramebuffer(k.READ_FRAMEBUFFER,null),Et.bindFramebuffer(k.DRAW_FRAMEBUFFER,null)}else if(J!==0||w.isRenderTargetTexture||Wt.has(w)){let pe=Wt.get(w),sn=Wt.get(V);Et.bindFramebuffer(k.READ_FRAMEBUFFER,P),Et.bindFramebuffer(k.DRAW_FRAMEBUFFER,G);for(let Xn=0;Xn<Nt;Xn++)$i?k.framebufferTextureLayer(k.READ_FRAMEBUFFER,k.COLOR_ATTACHMENT0,pe.__webglTexture,J,_e+Xn):k.framebufferTexture2D(k.READ_FRAMEBUFFER,k.COLOR_ATTACHMENT0,k.TEXTURE_2D,pe.__webglTexture,J),ps?k.framebufferTextureLayer(k.DRAW_FRAMEBUFFER,k.COLOR_ATTACHMENT0,sn.__webglTexture,Ct,tn+Xn):k.framebufferTexture2D(k.DRAW_FRAMEBUFFER,k.COLOR_ATTACHMENT0,k.TEXTURE_2D,sn.__webglTexture,Ct),J!==0?k.blitFramebuffer(Ht,re,Ht+Dt,re+Rt,Gt,xe,Gt+Dt,xe+Rt,k.COLOR_BUFFER_BIT,k.NEAREST):ps?k.copyTexSubImage3D(Bt,Ct,Gt,xe,tn+Xn,Ht,re,Dt,Rt):k.copyTexSubImage2D(Bt,Ct,Gt,xe,Ht,re,Dt,Rt);Et.bindFramebuffer(k.READ_FRAMEBUFFER,null),Et.bindFramebuffer(k.DRAW_FRAMEBUFFER,null)}else ps?w.isDataTexture||w.isData3DTexture?k.texSubImage3D(Bt,Ct,Gt,xe,tn,Dt,Rt,Nt,Fe,vn,Ue.data):V.isCompressedArrayTexture?k.compressedTexSubImage3D(Bt,Ct,Gt,xe,tn,Dt,Rt,Nt,Fe,Ue.data):k.texSubImage3D(Bt,Ct,Gt,xe,tn,Dt,Rt,Nt,Fe,vn,Ue):w.isDataTexture?k.texSubImage2D(k.TEXTURE_2D,Ct,Gt,xe,Dt,Rt,Fe,vn,Ue.data):w.isCompressedTexture?k.compressedTexSubImage2D(k.TEXTURE_2D,Ct,Gt,xe,Ue.width,Ue.height,Fe,Ue.data):k.texSubImage2D(k.TEXTURE_2D,Ct,Gt,xe,Dt,Rt,Fe,vn,Ue);Et.pixelStorei(k.UNPACK_ROW_LENGTH,dn),Et.pixelStorei(k.UNPACK_IMAGE_HEIGHT,Se),Et.pixelStorei(k.UNPACK_SKIP_PIXELS,ds),Et.pixelStorei(k.UNPACK_SKIP_ROWS,pn),Et.pixelStorei(k.UNPACK_SKIP_IMAGES,Dr),Ct===0&&V.generateMipmaps===!0&&V.mipmapsAutoUpdate===!0&&k.generateMipmap(Bt),Et.unbindTexture()},this.initRenderTarget=function(w){Wt.get(w).__webglFramebuffer===void 0&&Kt.setupRenderTarget(w)},this.initTexture=function(w){w.isCubeTexture?Kt.setTextureCube(w,0):w.isData3DTexture?Kt.setTexture3D(w,0):w.isDataArrayTexture||w.isCompressedArrayTexture?Kt.setTexture2DArray(w,0):Kt.setTexture2D(w,0),Et.unbindTexture()},this.resetState=function(){q=0,H=0,ct=null,Et.reset(),wt.reset()},typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}get coordinateSystem(){return Ti}get outputColorSpace(){return this._outputColorSpace}set outputColorSpace(t){this._outputColorSpace=t;let e=this.getContext();e.drawingBufferColorSpace=Me._getDrawingBufferColorSpace(t),e.unpackColorSpace=Me._getUnpackColorSpace()}};var a0=110,BT=new os({color:15311419,roughness:.55,metalness:.1}),Qf=new os({color:4411740,roughness:.5,metalness:.35}),l0=new os({color:11122626,roughness:.4,metalness:.5}),kT=new X(0,1,0),zT=i=>[...i.points,i.grip,i.approach,i.closing].flat(),Bh=class{group=new Bn;grip=null;#e=null;#t=[];#n=[];#i=0;#s=80;goTo(t){let e=zT(t);this.#e??=this.#a(t.points.length),this.#t=this.#n.length===e.length?this.#r():e,this.#n=e,this.#i=performance.now()}open(t){return t===void 0||t===this.#s?!1:(this.#s=t,!0)}step(){return this.#e?(this.#c(this.#e,this.#r()),performance.now()-this.#i<a0):!1}#r(){let t=Math.min((performance.now()-this.#i)/a0,1);return this.#n.map((e,n)=>this.#t[n]+(e-this.#t[n])*t)}#o(t,e){let n=new bn(t,e);return this.group.add(n),n}#a(t){let e=a=>58-30*(a/Math.max(t-1,1)),n=[];for(let a=0;a+1<t;++a)n.push(this.#o(new gr(e(a+1)*.8,e(a)*.8,1,24),BT));let s=[];for(let a=0;a<t;++a)s.push(this.#o(new _r(e(a),24,16),Qf));let r=()=>this.#o(new _i(9,24,52),l0),o=this.#o(new gr(95,110,24,40),Qf);return o.rotation.x=Math.PI/2,{links:n,joints:s,foot:o,stem:this.#o(new gr(16,20,1,20),l0),palm:this.#o(new _i(1,34,18),Qf),fingers:[r(),r()]}}#l(t,e,n){let s=n.clone().sub(e);t.visible=s.length()>1,t.position.copy(e).addScaledVector(s,.5),t.scale.set(1,Math.max(s.length(),1),1),t.quaternion.setFromUnitVectors(kT,s.normalize())}#c(t,e){let n=[];for(let _=0;_<e.length;_+=3)n.push(new X(e[_],e[_+1],e[_+2]));let[s,r,o]=n.splice(-3),{links:a,joints:l,foot:c,stem:f,palm:u,fingers:h}=t;c.position.copy(n[0]).setZ(12),a.forEach((_,g)=>this.#l(_,n[g],n[g+1])),l.forEach((_,g)=>_.position.copy(n[g])),this.grip=s;let d=new Qn().setFromRotationMatrix(new De().makeBasis(o,new X().crossVectors(r,o),r)),p=s.clone().addScaledVector(r,-58);this.#l(f,n[n.length-1],p),u.position.copy(p),u.quaternion.copy(d),u.scale.setX(this.#s+26),h.forEach((_,g)=>{_.position.copy(s).addScaledVector(r,-26).addScaledVector(o,(g?1:-1)*(this.#s/2+5)),_.quaternion.copy(d)})}};var td=i=>i*Math.PI/180;function c0({at:i,pan:t,tilt:e,roll:n},s){let[r,o]=[td(t+s.pan),td(e+s.tilt)],a=new X(-Math.cos(r)*Math.cos(o),Math.sin(r)*Math.cos(o),Math.sin(o)),l=new X(Math.sin(r),Math.cos(r),0).applyAxisAngle(a,td(n));return{eye:new X(...i),right:l,down:new X().crossVectors(a,l),ahead:a}}var ed=320;function VT({eye:i,right:t,down:e,ahead:n},s){let[,,r,o,a]=s,l=(u,h)=>i.clone().addScaledVector(n,ed).addScaledVector(t,u*ed*r/2/a).addScaledVector(e,h*ed*o/2/a),c=[l(-1,-1),l(1,-1),l(1,1),l(-1,1)],f=c.flatMap((u,h)=>[i,u,u,c[(h+1)%4]]);return new ss(new an().setFromPoints(f),new Ei({color:5223423,transparent:!0,opacity:.6}))}var GT={pan:0,tilt:0},kh=class{#e;#t;#n=null;#i=null;#s=null;#r=null;#o=null;frame=null;constructor(t,e,n){this.#e=e,this.#t=n;let s=(r,o)=>t.follow(r,a=>{o(a.length?ht(a[0]):null),this.#a()});s("(camera-model ?eyes ?width ?height ?focal ?cx ?cy ?base)",r=>this.#s=r),s("(head ?pan ?tilt ?state)",r=>this.#r=r&&{pan:r[1],tilt:r[2]}),s("(camera-pose ?x ?y ?z ?pan ?tilt ?roll ?state ?spread ?guess)",r=>{this.#i=r&&{at:[r[1],r[2],r[3]],pan:r[4],tilt:r[5],roll:r[6]}})}setCell({camera:t}){this.#n=t,this.#a()}#a(){this.#o&&this.#e.scene.remove(this.#o);let t=this.#n&&{...this.#n,...this.#i},e=t?.head?this.#r:GT;this.frame=t&&e?c0(t,e):null,this.#o=this.frame&&this.#s&&this.#s[4]>0?VT(this.frame,this.#s):null,this.#o&&this.#e.scene.add(this.#o),this.#e.says("camera",!!this.#o),this.#t(),this.#e.ask()}};var h0={type:"change"},id={type:"start"},f0={type:"end"},zh=new mr,u0=new mi,HT=Math.cos(70*Bf.DEG2RAD),En=new X,li=2*Math.PI,Pe={NONE:-1,ROTATE:0,DOLLY:1,PAN:2,TOUCH_ROTATE:3,TOUCH_PAN:4,TOUCH_DOLLY_PAN:5,TOUCH_DOLLY_ROTATE:6},nd=1e-6,Vh=class extends Fa{constructor(t,e=null){super(t,e),this.state=Pe.NONE,this.target=new X,this.cursor=new X,this.minDistance=0,this.maxDistance=1/0,this.minZoom=0,this.maxZoom=1/0,this.minTargetRadius=0,this.maxTargetRadius=1/0,this.minPolarAngle=0,this.maxPolarAngle=Math.PI,this.minAzimuthAngle=-1/0,this.maxAzimuthAngle=1/0,this.enableDamping=!1,this.dampingFactor=.05,this.enableZoom=!0,this.zoomSpeed=1,this.enableRotate=!0,this.rotateSpeed=1,this.keyRotateSpeed=1,this.enablePan=!0,this.panSpeed=1,this.screenSpacePanning=!0,this.keyPanSpeed=7,this.zoomToCursor=!1,this.autoRotate=!1,this.autoRotateSpeed=2,this.keys={LEFT:"ArrowLeft",UP:"ArrowUp",RIGHT:"ArrowRight",BOTTOM:"ArrowDown"},this.mouseButtons={LEFT:Js.ROTATE,MIDDLE:Js.DOLLY,RIGHT:Js.PAN},this.touches={ONE:Ks.ROTATE,TWO:Ks.DOLLY_PAN},this.target0=this.target.clone(),this.position0=this.object.position.clone(),this.zoom0=this.object.zoom,this._cursorStyle="auto",this._domElementKeyEvents=null,this._lastPosition=new X,this._lastQuaternion=new Qn,this._lastTargetPosition=new X,this._quat=new Qn().setFromUnitVectors(t.up,new X(0,1,0)),this._quatInverse=this._quat.clone().invert(),this._spherical=new Mo,this._sphericalDelta=new Mo,this._scale=1,this._panOffset=new X,this._rotateStart=new Jt,this._rotateEnd=new Jt,this._rotateDelta=new Jt,this._panStart=new Jt,this._panEnd=new Jt,this._panDelta=new Jt,this._dollyStart=new Jt,this._dollyEnd=new Jt,this._dollyDelta=new Jt,this._dollyDirection=new X,this._mouse=new Jt,this._performCursorZoom=!1,this._pointers=[],this._pointerPositions={},this._controlActive=!1,this._onPointerMove=XT.bind(this),this._onPointerDown=WT.bind(this),this._onPointerUp=qT.bind(this),this._onContextMenu=QT.bind(this),this._onMouseWheel=ZT.bind(this),this._onKeyDown=JT.bind(this),this._onTouchStart=KT.bind(this),this._onTouchMove=jT.bind(this),this._onMouseDown=$T.bind(this),this._onMouseMove=YT.bind(this),this._interceptControlDown=tE.bind(this),this._interceptControlUp=eE.bind(this),this.domElement!==null&&this.connect(this.domElement),this.update()}set cursorStyle(t){this._cursorStyle=t,t==="grab"?this.domElement.style.cursor="grab":this.domElement.style.cursor="auto"}get cursorStyle(){return this._cursorStyle}connect(t){super.connect(t),this.domElement.addEventListener("pointerdown",this._onPointerDown),this.domElement.addEventListener("pointercancel",this._onPointerUp),this.domElement.addEventListener("contextmenu",this._onContextMenu),this.domElement.addEventListener("wheel",this._onMouseWheel,{passive:!1}),this.domElement.ownerDocument.addEventListener("keydown",this._interceptControlDown,{passive:!0,capture:!0}),this.domElement.style.touchAction="none"}disconnect(){this.state=Pe.NONE,this.domElement.removeEventListener("pointerdown",this._onPointerDown),this.domElement.ownerDocument.removeEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.removeEventListener("pointerup",this._onPointerUp),this.domElement.removeEventListener("pointercancel",this._onPointerUp),this.domElement.removeEventListener("wheel",this._onMouseWheel),this.domElement.removeEventListener("contextmenu",this._onContextMenu),this.stopListenToKeyEvents(),this.domElement.ownerDocument.removeEventListener("keydown",this._interceptControlDown,{capture:!0}),this.domElement.ownerDocument.removeEventListener("keyup",this._interceptControlUp,{capture:!0}),this._controlActive=!1,this._pointers.length=0,this._pointerPositions={},this.domElement.style.touchAction="",this.domElement.style.cursor="auto"}dispose(){this.disconnect()}getPolarAngle(){return this._spherical.phi}getAzimuthalAngle(){return this._spherical.theta}getDistance(){return this.object.position.distanceTo(this.target)}listenToKeyEvents(t){t.addEventListener("keydown",this._onKeyDown),this._domElementKeyEvents=t}stopListenToKeyEvents(){this._domElementKeyEvents!==null&&(this._domElementKeyEvents.removeEventListener("keydown",this._onKeyDown),this._domElementKeyEvents=null)}saveState(){this.target0.copy(this.target),this.position0.copy(this.object.position),this.zoom0=this.object.zoom}reset(){this.target.copy(this.target0),this.object.position.copy(this.position0),this.object.zoom=this.zoom0,this.object.updateProjectionMatrix(),this.dispatchEvent(h0),this.update(),this.state=Pe.NONE}pan(t,e){this._pan(t,e),this.update()}dollyIn(t){this._dollyIn(t),this.update()}dollyOut(t){this._dollyOut(t),this.update()}rotateLeft(t){this._rotateLeft(t),this.update()}rotateUp(t){this._rotateUp(t),this.update()}update(t=null){let e=this.object.position;En.copy(e).sub(this.target),En.applyQuaternion(this._quat),this._spherical.setFromVector3(En),this.autoRotate&&this.state===Pe.NONE&&this._rotateLeft(this._getAutoRotationAngle(t)),this.enableDamping?(this._spherical.theta+=this._sphericalDelta.theta*this.dampingFactor,this._spherical.phi+=this._sphericalDelta.phi*this.dampingFactor):(this._spherical.theta+=this._sphericalDelta.theta,this._spherical.phi+=this._sphericalDelta.phi);let n=this.minAzimuthAngle,s=this.maxAzimuthAngle;isFinite(n)&&isFinite(s)&&(n<-Math.PI?n+=li:n>Math.PI&&(n-=li),s<-Math.PI?s+=li:s>Math.PI&&(s-=li),n<=s?this._spherical.theta=Math.max(n,Math.min(s,this._spherical.theta)):this._spherical.theta=this._spherical.theta>(n+s)/2?Math.max(n,this._spherical.theta):Math.min(s,this._spherical.theta)),this._spherical.phi=Math.max(this.minPolarAngle,Math.min(this.maxPolarAngle,this._spherical.phi)),this._spherical.makeSafe(),this.enableDamping===!0?this.target.addScaledVector(this._panOffset,this.dampingFactor):this.target.add(this._panOffset),this.target.sub(this.cursor),this.target.clampLength(this.minTargetRadius,this.maxTargetRadius),this.target.add(this.cursor);let r=!1;if(this.zoomToCursor&&this._performCursorZoom||this.object.isOrthographicCamera)this._spherical.radius=this._clampDistance(this._spherical.radius);else{let o=this._spherical.radius;this._spherical.radius=this._clampDistance(this._spherical.radius*this._scale),r=o!=this._spherical.radius}if(En.setFromSpherical(this._spherical),En.applyQuaternion(this._quatInverse),e.copy(this.target).add(En),this.object.lookAt(this.target),this.enableDamping===!0?(this._sphericalDelta.theta*=1-this.dampingFactor,this._sphericalDelta.phi*=1-this.dampingFactor,this._panOffset.multiplyScalar(1-this.dampingFactor)):(this._sphericalDelta.set(0,0,0),this._panOffset.set(0,0,0)),this.zoomToCursor&&this._performCursorZoom){let o=null;if(this.object.isPerspectiveCamera){let a=En.length();o=this._clampDistance(a*this._scale);let l=a-o;this.object.position.addScaledVector(this._dollyDirection,l),this.object.updateMatrixWorld(),r=!!l}else if(this.object.isOrthographicCamera){let a=new X(this._mouse.x,this._mouse.y,0);a.unproject(this.object);let l=this.object.zoom;this.object.zoom=Math.max(this.minZoom,Math.min(this.maxZoom,this.object.zoom/this._scale)),this.object.updateProjectionMatrix(),r=l!==this.object.zoom;let c=new X(this._mouse.x,this._mouse.y,0);c.unproject(this.object),this.object.position.sub(c).add(a),this.object.updateMatrixWorld(),o=En.length()}else console.warn("WARNING: OrbitControls.js encountered an unknown camera type - zoom to cursor disabled."),this.zoomToCursor=!1;o!==null&&(this.screenSpacePanning?this.target.set(0,0,-1).transformDirection(this.object.matrix).multiplyScalar(o).add(this.object.position):(zh.origin.copy(this.object.position),zh.direction.set(0,0,-1).transformDirection(this.object.matrix),Math.abs(this.object.up.dot(zh.direction))<HT?this.object.lookAt(this.target):(u0.setFromNormalAndCoplanarPoint(this.object.up,this.target),zh.intersectPlane(u0,this.target))))}else if(this.object.isOrthographicCamera){let o=this.object.zoom;this.object.zoom=Math.max(this.minZoom,Math.min(this.maxZoom,this.object.zoom/this._scale)),o!==this.object.zoom&&(this.object.updateProjectionMatrix(),r=!0)}return this._scale=1,this._performCursorZoom=!1,r||this._lastPosition.distanceToSquared(this.object.position)>nd||8*(1-this._lastQuaternion.dot(this.object.quaternion))>nd||this._lastTargetPosition.distanceToSquared(this.target)>nd?(this.dispatchEvent(h0),this._lastPosition.copy(this.object.position),this._lastQuaternion.copy(this.object.quaternion),this._lastTargetPosition.copy(this.target),!0):!1}_getAutoRotationAngle(t){return t!==null?li/60*this.autoRotateSpeed*t:li/60/60*this.autoRotateSpeed}_getZoomScale(t){let e=Math.abs(t*.01);return Math.pow(.95,this.zoomSpeed*e)}_rotateLeft(t){this._sphericalDelta.theta-=t}_rotateUp(t){this._sphericalDelta.phi-=t}_panLeft(t,e){En.setFromMatrixColumn(e,0),En.multiplyScalar(-t),this._panOffset.add(En)}_panUp(t,e){this.screenSpacePanning===!0?En.setFromMatrixColumn(e,1):(En.setFromMatrixColumn(e,0),En.crossVectors(this.object.up,En)),En.multiplyScalar(t),this._panOffset.add(En)}_pan(t,e){let n=this.domElement;if(this.object.isPerspectiveCamera){let s=this.object.position;En.copy(s).sub(this.target);let r=En.length();r*=Math.tan(this.object.fov/2*Math.PI/180),this._panLeft(2*t*r/n.clientHeight,this.object.matrix),this._panUp(2*e*r/n.clientHeight,this.object.matrix)}else this.object.isOrthographicCamera?(this._panLeft(t*(this.object.right-this.object.left)/this.object.zoom/n.clientWidth,this.object.matrix),this._panUp(e*(this.object.top-this.object.bottom)/this.object.zoom/n.clientHeight,this.object.matrix)):(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - pan disabled."),this.enablePan=!1)}_dollyOut(t){this.object.isPerspectiveCamera||this.object.isOrthographicCamera?this._scale/=t:(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - dolly/zoom disabled."),this.enableZoom=!1)}_dollyIn(t){this.object.isPerspectiveCamera||this.object.isOrthographicCamera?this._scale*=t:(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - dolly/zoom disabled."),this.enableZoom=!1)}_updateZoomParameters(t,e){if(!this.zoomToCursor)return;this._performCursorZoom=!0;let n=this.domElement.getBoundingClientRect(),s=t-n.left,r=e-n.top,o=n.width,a=n.height;this._mouse.x=s/o*2-1,this._mouse.y=-(r/a)*2+1,this._dollyDirection.set(this._mouse.x,this._mouse.y,1).unproject(this.object).sub(this.object.position).normalize()}_clampDistance(t){return Math.max(this.minDistance,Math.min(this.maxDistance,t))}_handleMouseDownRotate(t){this._rotateStart.set(t.clientX,t.clientY)}_handleMouseDownDolly(t){this._updateZoomParameters(t.clientX,t.clientY),this._dollyStart.set(t.clientX,t.clientY)}_handleMouseDownPan(t){this._panStart.set(t.clientX,t.clientY)}_handleMouseMoveRotate(t){this._rotateEnd.set(t.clientX,t.clientY),this._rotateDelta.subVectors(this._rotateEnd,this._rotateStart).multiplyScalar(this.rotateSpeed);let e=this.domElement;this._rotateLeft(li*this._rotateDelta.x/e.clientHeight),this._rotateUp(li*this._rotateDelta.y/e.clientHeight),this._rotateStart.copy(this._rotateEnd),this.update()}_handleMouseMoveDolly(t){this._dollyEnd.set(t.clientX,t.clientY),this._dollyDelta.subVectors(this._dollyEnd,this._dollyStart),this._dollyDelta.y>0?this._dollyOut(this._getZoomScale(this._dollyDelta.y)):this._dollyDelta.y<0&&this._dollyIn(this._getZoomScale(this._dollyDelta.y)),this._dollyStart.copy(this._dollyEnd),this.zoomToCursor&&(this._performCursorZoom=!0,this._dollyDirection.set(this._mouse.x,this._mouse.y,1).unproject(this.object).sub(this.object.position).normalize()),this.update()}_handleMouseMovePan(t){this._panEnd.set(t.clientX,t.clientY),this._panDelta.subVectors(this._panEnd,this._panStart).multiplyScalar(this.panSpeed),this._pan(this._panDelta.x,this._panDelta.y),this._panStart.copy(this._panEnd),this.update()}_handleMouseWheel(t){this._updateZoomParameters(t.clientX,t.clientY),t.deltaY<0?this._dollyIn(this._getZoomScale(t.deltaY)):t.deltaY>0&&this._dollyOut(this._getZoomScale(t.deltaY)),this.update()}_handleKeyDown(t){let e=!1;switch(t.code){case this.keys.UP:t.ctrlKey||t.metaKey||t.shiftKey?this.enableRotate&&this._rotateUp(li*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(0,this.keyPanSpeed),e=!0;break;case this.keys.BOTTOM:t.ctrlKey||t.metaKey||t.shiftKey?this.enableRotate&&this._rotateUp(-li*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(0,-this.keyPanSpeed),e=!0;break;case this.keys.LEFT:t.ctrlKey||t.metaKey||t.shiftKey?this.enableRotate&&this._rotateLeft(li*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(this.keyPanSpeed,0),e=!0;break;case this.keys.RIGHT:t.ctrlKey||t.metaKey||t.shiftKey?this.enableRotate&&this._rotateLeft(-li*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(-this.keyPanSpeed,0),e=!0;break}e&&(t.preventDefault(),this.update())}_handleTouchStartRotate(t){if(this._pointers.length===1)this._rotateStart.set(t.pageX,t.pageY);else{let e=this._getSecondPointerPosition(t),n=.5*(t.pageX+e.x),s=.5*(t.pageY+e.y);this._rotateStart.set(n,s)}}_handleTouchStartPan(t){if(this._pointers.length===1)this._panStart.set(t.pageX,t.pageY);else{let e=this._getSecondPointerPosition(t),n=.5*(t.pageX+e.x),s=.5*(t.pageY+e.y);this._panStart.set(n,s)}}_handleTouchStartDolly(t){let e=this._getSecondPointerPosition(t),n=t.pageX-e.x,s=t.pageY-e.y,r=Math.sqrt(n*n+s*s);this._dollyStart.set(0,r)}_handleTouchStartDollyPan(t){this.enableZoom&&this._handleTouchStartDolly(t),this.enablePan&&this._handleTouchStartPan(t)}_handleTouchStartDollyRotate(t){this.enableZoom&&this._handleTouchStartDolly(t),this.enableRotate&&this._handleTouchStartRotate(t)}_handleTouchMoveRotate(t){if(this._pointers.length==1)this._rotateEnd.set(t.pageX,t.pageY);else{let n=this._getSecondPointerPosition(t),s=.5*(t.pageX+n.x),r=.5*(t.pageY+n.y);this._rotateEnd.set(s,r)}this._rotateDelta.subVectors(this._rotateEnd,this._rotateStart).multiplyScalar(this.rotateSpeed);let e=this.domElement;this._rotateLeft(li*this._rotateDelta.x/e.clientHeight),this._rotateUp(li*this._rotateDelta.y/e.clientHeight),this._rotateStart.copy(this._rotateEnd)}_handleTouchMovePan(t){if(this._pointers.length===1)this._panEnd.set(t.pageX,t.pageY);else{let e=this._getSecondPointerPosition(t),n=.5*(t.pageX+e.x),s=.5*(t.pageY+e.y);this._panEnd.set(n,s)}this._panDelta.subVectors(this._panEnd,this._panStart).multiplyScalar(this.panSpeed),this._pan(this._panDelta.x,this._panDelta.y),this._panStart.copy(this._panEnd)}_handleTouchMoveDolly(t){let e=this._getSecondPointerPosition(t),n=t.pageX-e.x,s=t.pageY-e.y,r=Math.sqrt(n*n+s*s);this._dollyEnd.set(0,r),this._dollyDelta.set(0,Math.pow(this._dollyEnd.y/this._dollyStart.y,this.zoomSpeed)),this._dollyOut(this._dollyDelta.y),this._dollyStart.copy(this._dollyEnd);let o=(t.pageX+e.x)*.5,a=(t.pageY+e.y)*.5;this._updateZoomParameters(o,a)}_handleTouchMoveDollyPan(t){this.enableZoom&&this._handleTouchMoveDolly(t),this.enablePan&&this._handleTouchMovePan(t)}_handleTouchMoveDollyRotate(t){this.enableZoom&&this._handleTouchMoveDolly(t),this.enableRotate&&this._handleTouchMoveRotate(t)}_addPointer(t){this._pointers.push(t.pointerId)}_removePointer(t){delete this._pointerPositions[t.pointerId];for(let e=0;e<this._pointers.length;e++)if(this._pointers[e]==t.pointerId){this._pointers.splice(e,1);return}}_isTrackingPointer(t){for(let e=0;e<this._pointers.length;e++)if(this._pointers[e]==t.pointerId)return!0;return!1}_trackPointer(t){let e=this._pointerPositions[t.pointerId];e===void 0&&(e=new Jt,this._pointerPositions[t.pointerId]=e),e.set(t.pageX,t.pageY)}_getSecondPointerPosition(t){let e=t.pointerId===this._pointers[0]?this._pointers[1]:this._pointers[0];return this._pointerPositions[e]}_customWheelEvent(t){let e=t.deltaMode,n={clientX:t.clientX,clientY:t.clientY,deltaY:t.deltaY};switch(e){case 1:n.deltaY*=16;break;case 2:n.deltaY*=100;break}return t.ctrlKey&&!this._controlActive&&(n.deltaY*=10),n}};function WT(i){this.enabled!==!1&&(this._pointers.length===0&&(this.domElement.setPointerCapture(i.pointerId),this.domElement.ownerDocument.addEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.addEventListener("pointerup",this._onPointerUp)),!this._isTrackingPointer(i)&&(this._addPointer(i),i.pointerType==="touch"?this._onTouchStart(i):this._onMouseDown(i),this._cursorStyle==="grab"&&(this.domElement.style.cursor="grabbing")))}function XT(i){this.enabled!==!1&&(i.pointerType==="touch"?this._onTouchMove(i):this._onMouseMove(i))}function qT(i){switch(this._removePointer(i),this._pointers.length){case 0:this.domElement.releasePointerCapture(i.pointerId),this.domElement.ownerDocument.removeEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.removeEventListener("pointerup",this._onPointerUp),this.dispatchEvent(f0),this.state=Pe.NONE,this._cursorStyle==="grab"&&(this.domElement.style.cursor="grab");break;case 1:let t=this._pointers[0],e=this._pointerPositions[t];this._onTouchStart({pointerId:t,pageX:e.x,pageY:e.y});break}}function $T(i){let t;switch(i.button){case 0:t=this.mouseButtons.LEFT;break;case 1:t=this.mouseButtons.MIDDLE;break;case 2:t=this.mouseButtons.RIGHT;break;default:t=-1}switch(t){case Js.DOLLY:if(this.enableZoom===!1)return;this._handleMouseDownDolly(i),this.state=Pe.DOLLY;break;case Js.ROTATE:if(i.ctrlKey||i.metaKey||i.shiftKey){if(this.enablePan===!1)return;this._handleMouseDownPan(i),this.state=Pe.PAN}else{if(this.enableRotate===!1)return;this._handleMouseDownRotate(i),this.state=Pe.ROTATE}break;case Js.PAN:if(i.ctrlKey||i.metaKey||i.shiftKey){if(this.enableRotate===!1)return;this._handleMouseDownRotate(i),this.state=Pe.ROTATE}else{if(this.enablePan===!1)return;this._handleMouseDownPan(i),this.state=Pe.PAN}break;default:this.state=Pe.NONE}this.state!==Pe.NONE&&this.dispatchEvent(id)}function YT(i){switch(this.state){case Pe.ROTATE:if(this.enableRotate===!1)return;this._handleMouseMoveRotate(i);break;case Pe.DOLLY:if(this.enableZoom===!1)return;this._handleMouseMoveDolly(i);break;case Pe.PAN:if(this.enablePan===!1)return;this._handleMouseMovePan(i);break}}function ZT(i){this.enabled===!1||this.enableZoom===!1||this.state!==Pe.NONE||(i.preventDefault(),this.dispatchEvent(id),this._handleMouseWheel(this._customWheelEvent(i)),this.dispatchEvent(f0))}function JT(i){this.enabled!==!1&&this._handleKeyDown(i)}function KT(i){switch(this._trackPointer(i),this._pointers.length){case 1:switch(this.touches.ONE){case Ks.ROTATE:if(this.enableRotate===!1){this.state=Pe.NONE;break}this._handleTouchStartRotate(i),this.state=Pe.TOUCH_ROTATE;break;case Ks.PAN:if(this.enablePan===!1){this.state=Pe.NONE;break}this._handleTouchStartPan(i),this.state=Pe.TOUCH_PAN;break;default:this.state=Pe.NONE}break;case 2:switch(this.touches.TWO){case Ks.DOLLY_PAN:if(this.enableZoom===!1&&this.enablePan===!1)return;this._handleTouchStartDollyPan(i),this.state=Pe.TOUCH_DOLLY_PAN;break;case Ks.DOLLY_ROTATE:if(this.enableZoom===!1&&this.enableRotate===!1)return;this._handleTouchStartDollyRotate(i),this.state=Pe.TOUCH_DOLLY_ROTATE;break;default:this.state=Pe.NONE}break;default:this.state=Pe.NONE}this.state!==Pe.NONE&&this.dispatchEvent(id)}function jT(i){switch(this._trackPointer(i),this.state){case Pe.TOUCH_ROTATE:if(this.enableRotate===!1)return;this._handleTouchMoveRotate(i),this.update();break;case Pe.TOUCH_PAN:if(this.enablePan===!1)return;this._handleTouchMovePan(i),this.update();break;case Pe.TOUCH_DOLLY_PAN:if(this.enableZoom===!1&&this.enablePan===!1)return;this._handleTouchMoveDollyPan(i),this.update();break;case Pe.TOUCH_DOLLY_ROTATE:if(this.enableZoom===!1&&this.enableRotate===!1)return;this._handleTouchMoveDollyRotate(i),this.update();break;default:this.state=Pe.NONE}}function QT(i){this.enabled!==!1&&i.preventDefault()}function tE(i){i.key==="Control"&&(this._controlActive=!0,this.domElement.ownerDocument.addEventListener("keyup",this._interceptControlUp,{passive:!0,capture:!0}))}function eE(i){i.key==="Control"&&(this._controlActive=!1,this.domElement.ownerDocument.removeEventListener("keyup",this._interceptControlUp,{passive:!0,capture:!0}))}var nE=80;function iE(i){let t=i.getContext(),e=t.getExtension("WEBGL_debug_renderer_info"),n=t.getParameter(e?e.UNMASKED_RENDERER_WEBGL:t.RENDERER);return/swiftshader|llvmpipe|software/i.test(n)}var sd=class{#e;constructor(t,e){this.canvas=e,this.box=e.parentElement,this.renderer=t,this.pause=iE(t)?nE:0,this.#e=ii(()=>this.draw()),this.moving=()=>!1,this.renderer.setPixelRatio(Math.min(devicePixelRatio,2)),this.scene=new ga,this.scene.background=new ue(923422),this.camera=new Kn(36,1,10,8e3),this.camera.up.set(0,0,1),this.camera.position.set(1600,-1090,880),this.controls=new Vh(this.camera,e),this.controls.target.set(380,10,285),this.controls.maxDistance=4e3,this.controls.minDistance=200,this.controls.addEventListener("change",()=>this.ask()),this.controls.update(),this.light(),new ResizeObserver(()=>this.resize()).observe(this.box)}light(){let t=new Da(16777215,2.2);t.position.set(900,-700,1600);let e=new Ua(2e3,20,3493983,1911863);e.rotation.x=Math.PI/2,this.scene.add(new Pa(14674674,2569277,1.3),new Na(16777215,.25),t,e)}resize(){let{clientWidth:t,clientHeight:e}=this.box;!t||!e||(this.renderer.setSize(t,e,!1),this.camera.aspect=t/e,this.camera.updateProjectionMatrix(),this.ask())}ask(){this.#e()}says(t,e){this.canvas.dataset[t]=String(e)}draw(){let t=this.moving();this.renderer.render(this.scene,this.camera),t&&(this.pause?setTimeout(()=>this.ask(),this.pause):this.ask())}};function d0(){let i=bt("scene"),t;try{t=new Uh({canvas:i,antialias:!0})}catch{return bt("scene-note").hidden=!1,bt("scene-note").textContent="This browser draws nothing in three dimensions (WebGL is off). All else works.",null}return new sd(t,i)}var sE=50,rE=2,rd=sE*rE,p0=.04,oE=new _r(1,20,14),aE=new is({color:7127295,depthTest:!1,transparent:!0,opacity:.75});function lE([i,t,e,n,s,r]){let o=Math.sqrt(i),[a,l]=[t/o,e/o],c=Math.sqrt(n-a*a),f=(s-a*l)/c,u=Math.sqrt(r-l*l-f*f);return[o,c,u].every(h=>h>0)?[[o,a,l],[0,c,f],[0,0,u]]:null}function cE({spread:i,covariance:t},{eye:e,right:n,down:s,ahead:r},o){let a=t&&lE(t);if(a){let u=([h,d,p])=>new X().addScaledVector(n,h).addScaledVector(s,d).addScaledVector(r,p);return[u(a[0]),u(a[1]),u(a[2])]}if(i===void 0||!(i>0))return null;let l=new X().subVectors(o,e).normalize(),c=new X().crossVectors(l,s).normalize(),f=new X().crossVectors(l,c);return[l.multiplyScalar(i),c.multiplyScalar(p0),f.multiplyScalar(p0)]}var Gh=class{mesh=new bn(oE,aE);constructor(){this.mesh.matrixAutoUpdate=!1,this.mesh.visible=!1}show(t,e,n){let s=t&&e&&n?cE(t,e,n):null;if(this.mesh.visible=s!==null,!s)return;let[r,o,a]=s;this.mesh.matrix=new De().makeBasis(r,o,a).scale(new X(rd,rd,rd)),this.mesh.matrixWorldNeedsUpdate=!0}};var hE=160,Hh="end-effector",uE=.45,od={circle:i=>i.arc(64,64,34,0,2*Math.PI),square:i=>i.rect(33,33,62,62),triangle:i=>m0(i,[[64,26],[102,96],[26,96]]),cross:i=>m0(i,[[52,26],[76,26],[76,52],[102,52],[102,76],[76,76],[76,102],[52,102],[52,76],[26,76],[26,52],[52,52]])};function m0(i,t){t.forEach(([e,n],s)=>s?i.lineTo(e,n):i.moveTo(e,n)),i.closePath()}function g0(i,t,e){let n=document.createElement("canvas");n.width=i,n.height=t,e(ji(n));let s=new Ma(n);return s.colorSpace=Jn,s}function fE(i){return g0(128,128,t=>{let[e,n]=i===Hh?["#14181b","#f4f6f7"]:["#f4f6f7","#14181b"];t.fillStyle=e,t.fillRect(0,0,128,128),t.fillStyle=n,t.beginPath();let s=i===Hh?od.triangle:Object.hasOwn(od,i)?od[i]:null;s&&s(t),t.fill(),!s&&(t.font="bold 64px system-ui, sans-serif",t.textAlign="center",t.fillText(i.slice(0,1).toUpperCase(),64,86))})}function dE(i){return g0(256,64,t=>{t.font="600 34px system-ui, sans-serif",t.textAlign="center",t.lineWidth=7,t.strokeStyle="#0e171e";let e=i.length>14?`${i.slice(0,13)}\u2026`:i;t.strokeText(e,128,44),t.fillStyle="#ffffff",t.fillText(e,128,44)})}var Wh=class{group=new Bn;#e;#t=null;#n=null;#i=0;#s;#r=new Gh;#o;constructor(t,e){this.#e=e;let n=new os({color:15133420,roughness:.8}),s=fE(t);s.center.set(.5,.5),s.rotation=Math.PI/2;let r=new os({map:s,roughness:.8}),o=t===Hh?4:e,a=t===Hh?e*.7:e,l=new bn(new _i(o,a,a),[r,n,n,n,n,n]);l.position.setX(-o/2);let c=new va(new xo({map:dE(t),depthTest:!1}));c.scale.set(e*2.4,e*.6,1),c.position.set(-e/2,0,e*.85),this.#s=[n,r],this.#o=new bn(new Aa(e*.85,e*.97,40),new is({color:15901498,side:oi,transparent:!0})),this.#o.position.set(-o/2,0,-a/2+2),this.#o.visible=!1,this.group.add(l,c,this.#r.mesh,this.#o)}believe(t,e){let n=t&&!["seen","found"].includes(t.state);for(let s of this.#s)s.opacity=n?uE:1,s.transparent=!!n;this.#r.show(t,e,this.#n)}hasSpread(){return this.#r.mesh.visible}mark(t){this.#o.visible=t}goTo(t,e,n){let s=new X(t,e,n);this.#t=this.#n?this.group.position.clone():s,this.#n=s,this.#i=performance.now()}step(){let t=Math.min((performance.now()-this.#i)/hE,1);return this.#t&&this.#n&&this.group.position.lerpVectors(this.#t,this.#n,t),t<1}top(){return this.group.position.clone().add(new X(-this.#e/2,0,this.#e/2))}};var pE=1.5,Xh=class{group=new Bn;constructor({parts:t}){let e=(l,c)=>{let f=2*Math.PI*l/t.length;return[c*Math.cos(f),c*Math.sin(f),pE]},n=[],s=[];t.forEach(([l,c],f)=>{let u=(f+1)%t.length,[h,d]=t[u];if(c===0||d===0)return;let[p,_,g,m]=[e(f,l),e(f,c),e(u,d),e(u,h)];n.push(...p,..._,...g,...p,...g,...m),s.push(..._,...g,...p,...m)});let r=new an().setAttribute("position",new Re(n,3)),o=new an().setAttribute("position",new Re(s,3)),a={color:8376715,transparent:!0,opacity:.07,side:oi,depthWrite:!1};this.group.add(new bn(r,new is(a)),new ss(o,new Ei({color:5214043})))}standAt([t,e]){this.group.position.set(t,e,0)}};var mE=new Ei({color:16732120,depthTest:!1,transparent:!0}),qh=class{#e=new Bn;#t=new Map;#n=60;#i=C("span",{id:"truth-note",class:"quiet"});#s=C("input",{type:"checkbox",id:"truth"});#r=C("label",{class:"over",id:"truth-choice",hidden:!0},this.#s," The world\u2019s truth ",this.#i);constructor(t,e){this.view=e,e.scene.add(this.#e),bt("scene-card").append(this.#r),this.#s.addEventListener("change",()=>{this.#a([]),this.#i.textContent="",t.layTruth(this.#s.checked?(n,s)=>this.#o(n,s):null)})}setCell({truth:t,cube:e}){this.#r.hidden=!t,this.#n=e}#o(t,e){if(!this.#s.checked)return;let n=(t??[]).filter(s=>Y(s[0])==="cube"&&Y(s[7])!=="gone");this.#i.textContent=t?`pink: ${n.length} objects, known to no agent`:e??"",this.#a(n)}#a(t){let e=new Set(t.map(n=>Y(n[1])));for(let[n,s]of this.#t)e.has(n)||(this.#e.remove(s),this.#t.delete(n));for(let[,n,s,r,o,a]of t){let l=this.#t.get(Y(n))??this.#l(Y(n));l.position.set(s,r,o),l.rotation.z=a*Math.PI/180}this.view.says("truth",this.#t.size),this.view.ask()}#l(t){let e=new Ta(new _i(this.#n,this.#n,this.#n)),n=new ss(e,mE);return n.renderOrder=1,this.#t.set(t,n),this.#e.add(n),n}};var gE=[0,1,2,6,7,11],_E=21;function _0(i){let t=o=>i.filter(Array.isArray).find(a=>Y(a[0])===o)??[],[,e,n]=t("range"),s=t("pose")[7],r=Array.isArray(s)&&s.length===_E&&s.every(Number.isFinite);return{range:e,spread:n,covariance:r?gE.map(o=>s[o]):void 0}}function x0(i,t,e){let n=i.get(t);(!n||(n.confidence??0)<(e.confidence??0))&&i.set(t,e)}function y0(i,t){let e=new Map;for(let[,,,,s]of i.map(ht))for(let[r,o,...a]of s){let l=typeof a[0]=="number"?a[0]:void 0;x0(e,Y(r),{state:Y(o),confidence:l,..._0(a)})}let n=new Set(e.keys());for(let[,,s,,r,,,,o]of t.map(ht))n.has(Y(s))||x0(e,Y(s),{state:"found",confidence:r,..._0(o)});return e}var ad=8;function xE(i){if(!i)return"not looked for";let{state:t,confidence:e,spread:n}=i;if(t!=="seen"&&t!=="found")return t;let s=e===void 0?t:`${(e*100).toFixed(0)} %`;return n&&n>0?`${s}  \xB1${(2*n).toFixed(1)} mm`:s}function v0(i){let t=bt("beliefs"),e=[],n=new Map,s=ii(()=>{let r=e.slice(0,ad).flatMap(a=>[C("dt",{},$t(a,16)),C("dd",{},xE(n.get(a)))]),o=e.length>ad?[C("dt",{},"and"),C("dd",{},`${e.length-ad} more`)]:[];t.replaceChildren(...r,...o)});return i.follow("(place ?name ?x ?y ?z ?frame)",r=>{e=r.map(o=>Y(ht(o)[1])).sort(),s()}),r=>{n=r,s()}}var yE="NO_ACTION",vE=i=>i.replace(/\d+\.\d+/g,t=>String(Math.round(Number(t)*10)/10)),S0=i=>i.map(t=>hl(t,0)).join("  "),SE=i=>i.map(([,t],e)=>t.split(" ")[1]===i[e+1]?.[1].split(" ")[1]?t.split(" ")[0]:t).join("  "),ME={pose:([,,...i])=>[["grip",`${S0(i.slice(0,3))} mm`],["turned",`${S0(i.slice(3))} \xB0`]],joints:([,i,t],e)=>[["joints",SE(e.words(Y(i),t,0))]],gripper:([,,i])=>[["gripper",`${i.toFixed(0)} mm`]],arm:([,,i,t])=>[["arm",Y(t)===yE?Y(i):`${Y(i)}  ${vE(Y(t)).slice(0,40)}`]]},$h=class{#e="robot";#t={};#n;#i;constructor(t,e,n){this.#n=e,this.#i=n,e.onChange(()=>this.#r());let s=(r,o)=>t.follow(o,a=>{this.#t[r]=a.map(ht),this.#r()});s("pose","(arm-pose ?robot ?x ?y ?z ?rx ?ry ?rz)"),s("joints","(arm-joints ?robot ?joints)"),s("gripper","(gripper ?robot ?opening)"),s("arm","(arm ?robot ?state ?action)")}show(t){this.#e=t,this.#r()}#s(t){return this.#t[t]?.find(e=>Y(e[1])===this.#e)}#r(){let t=Object.entries(ME).flatMap(([e,n])=>{let s=this.#s(e);return s?n(s,this.#n):[]});bt("readings").replaceChildren(...t.flatMap(([e,n])=>[C("dt",{},e),C("dd",{},n)])),this.#i(this.#s("gripper")?.[2])}};var bE=64,wE={arms:[],reaches:{},cube:60},ld=class{line=new yo(new an().setFromPoints([new X,new X]),new Ca({color:15901498,dashSize:14,gapSize:9}));show(t,e){if(this.line.visible=!!(t&&e),!t||!e)return;let n=[t,e].flatMap(s=>[s.x,s.y,s.z]);this.line.geometry.setAttribute("position",new Re(n,3)),this.line.computeLineDistances()}};function TE(i,t){let e={servo:"",operation:"",pursued:!1},n=()=>t(e.pursued?e.servo||e.operation:"");i.follow("(servo ?state ?object ?x ?y ?d)",s=>{e.servo=s.length?Y(ht(s[0])[2]):"",n()}),i.follow("(operation ?i ?operation ?state)",s=>{let[,,r,o]=s.length?ht(s[0]):[];e.operation=Y(o)==="running"?Y(r.at(-1)):"",n()}),i.follow("(goal-state ?n ?state ?detail)",s=>{e.pursued=s.some(r=>Y(ht(r)[2])==="running"),n()})}function M0(i,t,e){let n=d0(),s=null,r=null,o="",a=wE,l="",c=new Map,f=new Map,u=new $h(i,e,U=>n&&s?.open(U)&&n.ask()),h=v0(i);if(!n)return t.onChange(()=>u.show(t.server("robot")||"robot")),{moveArm:()=>{},setCell:()=>{}};let d=new Bn,p=new ld,_=new Map,g=new kh(i,n,()=>A()),m=new qh(i,n);n.scene.add(d,p.line),n.moving=()=>{let U=s?.step()??!1,N=[...c.values()].map(L=>L.step());return p.show(s?.grip,c.get(o)?.top()),U||N.includes(!0)};let v=()=>{for(let[U,N]of c)N.mark(U===o);n.says("target",c.has(o)?o:""),n.ask()},A=()=>{for(let[U,N]of c)N.believe(_.get(U),g.frame);n.says("spread",[...c.values()].filter(U=>U.hasSpread()).length)},S=(U,[,,N,L,z])=>{let O=c.get(U);if(!O){if(c.size>=bE)return;O=new Wh(U,a.cube),c.set(U,O),d.add(O.group)}O.goTo(N,L,z)};i.follow("(place ?name ?x ?y ?z ?frame)",U=>{let N=new Map(U.map(L=>[Y(ht(L)[1]),ht(L)]));for(let[L,z]of c)N.has(L)||(d.remove(z.group),c.delete(L));for(let[L,z]of N)S(L,z);A(),v()});let R={looks:[],found:[]},E=(U,N)=>i.follow(N,L=>{R[U]=L,_=y0(R.looks,R.found),A(),h(_),n.ask()});E("looks","(look ?eyes ?frame ?text ?of)"),E("found","(found ?eyes ?name ?frame ?confidence ?second ?margin ?others ?places)"),TE(i,U=>{o=U,v()});let x=U=>{s||(s=new Bh,n.scene.add(s.group)),s.goTo(U),r?.standAt(U.points[0]),n.ask()},T=()=>{l=t.server("robot")||(a.arms[0]??"robot"),u.show(l);for(let N of[s,r])N&&n.scene.remove(N.group);s=null,r=a.reaches[l]?new Xh(a.reaches[l]):null,r&&n.scene.add(r.group),n.says("reach",!!r),n.says("arm",l);let U=f.get(l);U&&x(U),n.ask()};return t.onChange(()=>(t.server("robot")||l)!==l&&T()),{moveArm:U=>{f.set(U.arm,U),U.arm===l&&x(U)},setCell:U=>{a=U,g.setCell(U),m.setCell(U),T()}}}var EE="uplot",AE="u-hz",CE="u-vt",RE="u-title",PE="u-wrap",IE="u-under",LE="u-over",DE="u-axis",Tr="u-off",NE="u-select",UE="u-cursor-x",FE="u-cursor-y",OE="u-cursor-pt",BE="u-legend",kE="u-live",zE="u-inline",VE="u-series",GE="u-marker",b0="u-label",HE="u-value",Ja="width",Ka="height";var w0="bottom",Ro="left",cd="right",Ed="#000",T0=Ed+"0",hd="mousemove",E0="mousedown",ud="mouseup",A0="mouseenter",C0="mouseleave",R0="dblclick",WE="resize",XE="scroll",P0="change",jh="dppxchange",Ad="--",Fo=typeof window<"u",gd=Fo?document:null,Io=Fo?window:null,qE=Fo?navigator:null,Ie,Yh;function _d(){let i=devicePixelRatio;Ie!=i&&(Ie=i,Yh&&yd(P0,Yh,_d),Yh=matchMedia(`(min-resolution: ${Ie-.001}dppx) and (max-resolution: ${Ie+.001}dppx)`),Er(P0,Yh,_d),Io.dispatchEvent(new CustomEvent(jh)))}function yi(i,t){if(t!=null){let e=i.classList;!e.contains(t)&&e.add(t)}}function xd(i,t){let e=i.classList;e.contains(t)&&e.remove(t)}function Je(i,t,e){i.style[t]=e+"px"}function Gi(i,t,e,n){let s=gd.createElement(i);return t!=null&&yi(s,t),e?.insertBefore(s,n),s}function Ai(i,t){return Gi("div",i,t)}var I0=new WeakMap;function hs(i,t,e,n,s){let r="translate("+t+"px,"+e+"px)",o=I0.get(i);r!=o&&(i.style.transform=r,I0.set(i,r),t<0||e<0||t>n||e>s?yi(i,Tr):xd(i,Tr))}var L0=new WeakMap;function D0(i,t,e){let n=t+e,s=L0.get(i);n!=s&&(L0.set(i,n),i.style.background=t,i.style.borderColor=e)}var N0=new WeakMap;function U0(i,t,e,n){let s=t+""+e,r=N0.get(i);s!=r&&(N0.set(i,s),i.style.height=e+"px",i.style.width=t+"px",i.style.marginLeft=n?-t/2+"px":0,i.style.marginTop=n?-e/2+"px":0)}var Cd={passive:!0},$E={...Cd,capture:!0};function Er(i,t,e,n){t.addEventListener(i,e,n?$E:Cd)}function yd(i,t,e,n){t.removeEventListener(i,e,Cd)}Fo&&_d();function Hi(i,t,e,n){let s;e=e||0,n=n||t.length-1;let r=n<=2147483647;for(;n-e>1;)s=r?e+n>>1:vi((e+n)/2),t[s]<i?e=s:n=s;return i-t[e]<=t[n]-i?e:n}function c_(i){return(e,n,s)=>{let r=-1,o=-1;for(let a=n;a<=s;a++)if(i(e[a])){r=a;break}for(let a=s;a>=n;a--)if(i(e[a])){o=a;break}return[r,o]}}var h_=i=>i!=null,u_=i=>i!=null&&i>0,eu=c_(h_),YE=c_(u_);function ZE(i,t,e,n=0,s=!1){let r=s?YE:eu,o=s?u_:h_;[t,e]=r(i,t,e);let a=i[t],l=i[t];if(t>-1)if(n==1)a=i[t],l=i[e];else if(n==-1)a=i[e],l=i[t];else for(let c=t;c<=e;c++){let f=i[c];o(f)&&(f<a?a=f:f>l&&(l=f))}return[a??Ve,l??-Ve]}function nu(i,t,e,n){let s=B0(i),r=B0(t);i==t&&(s==-1?(i*=e,t/=e):(i/=e,t*=e));let o=e==10?Rs:f_,a=s==1?vi:Ci,l=r==1?Ci:vi,c=a(o(Cn(i))),f=l(o(Cn(t))),u=Lo(e,c),h=Lo(e,f);return e==10&&(c<0&&(u=Ge(u,-c)),f<0&&(h=Ge(h,-f))),n||e==2?(i=u*s,t=h*r):(i=g_(i,u),t=iu(t,h)),[i,t]}function Rd(i,t,e,n){let s=nu(i,t,e,n);return i==0&&(s[0]=0),t==0&&(s[1]=0),s}var Pd=.1,F0={mode:3,pad:Pd},Qa={pad:0,soft:null,mode:0},JE={min:Qa,max:Qa};function Qh(i,t,e,n){return su(e)?O0(i,t,e):(Qa.pad=e,Qa.soft=n?0:null,Qa.mode=n?3:0,O0(i,t,JE))}function Ae(i,t){return i??t}function KE(i,t,e){for(t=Ae(t,0),e=Ae(e,i.length-1);t<=e;){if(i[t]!=null)return!0;t++}return!1}function O0(i,t,e){let n=e.min,s=e.max,r=Ae(n.pad,0),o=Ae(s.pad,0),a=Ae(n.hard,-Ve),l=Ae(s.hard,Ve),c=Ae(n.soft,Ve),f=Ae(s.soft,-Ve),u=Ae(n.mode,0),h=Ae(s.mode,0),d=t-i,p=Rs(d),_=ni(Cn(i),Cn(t)),g=Rs(_),m=Cn(g-p);(d<1e-24||m>10)&&(d=0,(i==0||t==0)&&(d=1e-24,u==2&&c!=Ve&&(r=0),h==2&&f!=-Ve&&(o=0)));let v=d||_||1e3,A=Rs(v),S=Lo(10,vi(A)),R=v*(d==0?i==0?.1:1:r),E=Ge(g_(i-R,S/10),24),x=i>=c&&(u==1||u==3&&E<=c||u==2&&E>=c)?c:Ve,T=ni(a,E<x&&i>=x?x:Wi(x,E)),U=v*(d==0?t==0?.1:1:o),N=Ge(iu(t+U,S/10),24),L=t<=f&&(h==1||h==3&&N>=f||h==2&&N<=f)?f:-Ve,z=Wi(l,N>L&&t<=L?L:ni(L,N));return T==z&&T==0&&(z=100),[T,z]}var jE=new Intl.NumberFormat(Fo?qE.language:"en-US"),Id=i=>jE.format(i),Si=Math,Kh=Si.PI,Cn=Si.abs,vi=Si.floor,An=Si.round,Ci=Si.ceil,Wi=Si.min,ni=Si.max,Lo=Si.pow,B0=Si.sign,Rs=Si.log10,f_=Si.log2,QE=(i,t=1)=>Si.sinh(i)*t,fd=(i,t=1)=>Si.asinh(i/t),Ve=1/0;function k0(i){return(Rs((i^i>>31)-(i>>31))|0)+1}function vd(i,t,e){return Wi(ni(i,t),e)}function d_(i){return typeof i=="function"}function be(i){return d_(i)?i:()=>i}var t1=()=>{},p_=i=>i,m_=(i,t)=>t,e1=i=>null,z0=i=>!0,V0=(i,t)=>i==t,n1=/\.\d*?(?=9{6,}|0{6,})/gm,Ar=i=>{if(x_(i)||nr.has(i))return i;let t=`${i}`,e=t.match(n1);if(e==null)return i;let n=e[0].length-1;if(t.indexOf("e-")!=-1){let[s,r]=t.split("e");return+`${Ar(s)}e${r}`}return Ge(i,n)};function br(i,t){return Ar(Ge(Ar(i/t))*t)}function iu(i,t){return Ar(Ci(Ar(i/t))*t)}function g_(i,t){return Ar(vi(Ar(i/t))*t)}function Ge(i,t=0){if(x_(i))return i;let e=10**t,n=i*e*(1+Number.EPSILON);return An(n)/e}var nr=new Map;function __(i){return((""+i).split(".")[1]||"").length}function el(i,t,e,n){let s=[],r=n.map(__);for(let o=t;o<e;o++){let a=Cn(o),l=Ge(Lo(i,o),a);for(let c=0;c<n.length;c++){let f=i==10?+`${n[c]}e${o}`:n[c]*l,u=(o>=0?0:a)+(o>=r[c]?0:r[c]),h=i==10?f:Ge(f,u);s.push(h),nr.set(h,u)}}return s}var tl={},Ld=[],Do=[null,null],er=Array.isArray,x_=Number.isInteger,i1=i=>i===void 0;function G0(i){return typeof i=="string"}function su(i){let t=!1;if(i!=null){let e=i.constructor;t=e==null||e==Object}return t}function s1(i){return i!=null&&typeof i=="object"}var r1=Object.getPrototypeOf(Uint8Array),y_="__proto__";function No(i,t=su){let e;if(er(i)){let n=i.find(s=>s!=null);if(er(n)||t(n)){e=Array(i.length);for(let s=0;s<i.length;s++)e[s]=No(i[s],t)}else e=i.slice()}else if(i instanceof r1)e=i.slice();else if(t(i)){e={};for(let n in i)n!=y_&&(e[n]=No(i[n],t))}else e=i;return e}function xn(i){let t=arguments;for(let e=1;e<t.length;e++){let n=t[e];for(let s in n)s!=y_&&(su(i[s])?xn(i[s],No(n[s])):i[s]=No(n[s]))}return i}var o1=0,a1=1,l1=2;function c1(i,t,e){for(let n=0,s,r=-1;n<t.length;n++){let o=t[n];if(o>r){for(s=o-1;s>=0&&i[s]==null;)i[s--]=null;for(s=o+1;s<e&&i[s]==null;)i[r=s++]=null}}}function h1(i,t){if(d1(i)){let o=i[0].slice();for(let a=1;a<i.length;a++)o.push(...i[a].slice(1));return p1(o[0])||(o=f1(o)),o}let e=new Set;for(let o=0;o<i.length;o++){let l=i[o][0],c=l.length;for(let f=0;f<c;f++)e.add(l[f])}let n=[Array.from(e).sort((o,a)=>o-a)],s=n[0].length,r=new Map;for(let o=0;o<s;o++)r.set(n[0][o],o);for(let o=0;o<i.length;o++){let a=i[o],l=a[0];for(let c=1;c<a.length;c++){let f=a[c],u=Array(s).fill(void 0),h=t?t[o][c]:a1,d=[];for(let p=0;p<f.length;p++){let _=f[p],g=r.get(l[p]);_===null?h!=o1&&(u[g]=_,h==l1&&d.push(g)):u[g]=_}c1(u,d,s),n.push(u)}}return n}var u1=typeof queueMicrotask>"u"?i=>Promise.resolve().then(i):queueMicrotask;function f1(i){let t=i[0],e=t.length,n=Array(e);for(let r=0;r<n.length;r++)n[r]=r;n.sort((r,o)=>t[r]-t[o]);let s=[];for(let r=0;r<i.length;r++){let o=i[r],a=Array(e);for(let l=0;l<e;l++)a[l]=o[n[l]];s.push(a)}return s}function d1(i){let t=i[0][0],e=t.length;for(let n=1;n<i.length;n++){let s=i[n][0];if(s.length!=e)return!1;if(s!=t){for(let r=0;r<e;r++)if(s[r]!=t[r])return!1}}return!0}function p1(i,t=100){let e=i.length;if(e<=1)return!0;let n=0,s=e-1;for(;n<=s&&i[n]==null;)n++;for(;s>=n&&i[s]==null;)s--;if(s<=n)return!0;let r=ni(1,vi((s-n+1)/t));for(let o=i[n],a=n+r;a<=s;a+=r){let l=i[a];if(l!=null){if(l<=o)return!1;o=l}}return!0}var v_=["January","February","March","April","May","June","July","August","September","October","November","December"],S_=["Sunday","Monday","Tuesday","Wednesday","Thursday","Friday","Saturday"];function M_(i){return i.slice(0,3)}var m1=S_.map(M_),g1=v_.map(M_),_1={MMMM:v_,MMM:g1,WWWW:S_,WWW:m1};function Za(i){return(i<10?"0":"")+i}function x1(i){return(i<10?"00":i<100?"0":"")+i}var y1={YYYY:i=>i.getFullYear(),YY:i=>(i.getFullYear()+"").slice(2),MMMM:(i,t)=>t.MMMM[i.getMonth()],MMM:(i,t)=>t.MMM[i.getMonth()],MM:i=>Za(i.getMonth()+1),M:i=>i.getMonth()+1,DD:i=>Za(i.getDate()),D:i=>i.getDate(),WWWW:(i,t)=>t.WWWW[i.getDay()],WWW:(i,t)=>t.WWW[i.getDay()],HH:i=>Za(i.getHours()),H:i=>i.getHours(),h:i=>{let t=i.getHours();return t==0?12:t>12?t-12:t},AA:i=>i.getHours()>=12?"PM":"AM",aa:i=>i.getHours()>=12?"pm":"am",a:i=>i.getHours()>=12?"p":"a",mm:i=>Za(i.getMinutes()),m:i=>i.getMinutes(),ss:i=>Za(i.getSeconds()),s:i=>i.getSeconds(),fff:i=>x1(i.getMilliseconds())};function Dd(i,t){t=t||_1;let e=[],n=/\{([a-z]+)\}|[^{]+/gi,s;for(;s=n.exec(i);)e.push(s[0][0]=="{"?y1[s[1]]:s[0]);return r=>{let o="";for(let a=0;a<e.length;a++)o+=typeof e[a]=="string"?e[a]:e[a](r,t);return o}}var v1=new Intl.DateTimeFormat().resolvedOptions().timeZone;function S1(i,t){let e;return t=="UTC"||t=="Etc/UTC"?e=new Date(+i+i.getTimezoneOffset()*6e4):t==v1?e=i:(e=new Date(i.toLocaleString("en-US",{timeZone:t})),e.setMilliseconds(i.getMilliseconds())),e}var b_=i=>i%1==0,tu=[1,2,2.5,5],M1=el(10,-32,0,tu),w_=el(10,0,32,tu),b1=w_.filter(b_),wr=M1.concat(w_),Nd=`
`,T_="{YYYY}",H0=Nd+T_,E_="{M}/{D}",ja=Nd+E_,Zh=ja+"/{YY}",A_="{aa}",w1="{h}:{mm}",Po=w1+A_,W0=Nd+Po,X0=":{ss}",Ne=null;function C_(i){let t=i*1e3,e=t*60,n=e*60,s=n*24,r=s*30,o=s*365,l=(i==1?el(10,0,3,tu).filter(b_):el(10,-3,0,tu)).concat([t,t*5,t*10,t*15,t*30,e,e*5,e*10,e*15,e*30,n,n*2,n*3,n*4,n*6,n*8,n*12,s,s*2,s*3,s*4,s*5,s*6,s*7,s*8,s*9,s*10,s*15,r,r*2,r*3,r*4,r*6,o,o*2,o*5,o*10,o*25,o*50,o*100]),c=[[o,T_,Ne,Ne,Ne,Ne,Ne,Ne,1],[s*28,"{MMM}",H0,Ne,Ne,Ne,Ne,Ne,1],[s,E_,H0,Ne,Ne,Ne,Ne,Ne,1],[n,"{h}"+A_,Zh,Ne,ja,Ne,Ne,Ne,1],[e,Po,Zh,Ne,ja,Ne,Ne,Ne,1],[t,X0,Zh+" "+Po,Ne,ja+" "+Po,Ne,W0,Ne,1],[i,X0+".{fff}",Zh+" "+Po,Ne,ja+" "+Po,Ne,W0,Ne,1]];function f(u){return(h,d,p,_,g,m)=>{let v=[],A=g>=o,S=g>=r&&g<o,R=u(p),E=Ge(R*i,3),x=dd(R.getFullYear(),A?0:R.getMonth(),S||A?1:R.getDate()),T=Ge(x*i,3);if(S||A){let U=S?g/r:0,N=A?g/o:0,L=E==T?E:Ge(dd(x.getFullYear()+N,x.getMonth()+U,1)*i,3),z=new Date(An(L/i)),O=z.getFullYear(),P=z.getMonth();for(let G=0;L<=_;G++){let q=dd(O+N*G,P+U*G,1),H=q-u(Ge(q*i,3));L=Ge((+q+H)*i,3),L<=_&&v.push(L)}}else{let U=g>=s?s:g,N=vi(p)-vi(E),L=T+N+iu(E-T,U);v.push(L);let z=u(L),O=z.getHours()+z.getMinutes()/e+z.getSeconds()/n,P=g/n,G=h.axes[d]._space,q=m/G;for(;L=Ge(L+g,i==1?0:3),!(L>_);)if(P>1){let H=vi(Ge(O+P,6))%24,et=u(L).getHours()-H;et>1&&(et=-1),L-=et*n,O=(O+P)%24;let st=v[v.length-1];Ge((L-st)/g,3)*q>=.7&&v.push(L)}else v.push(L)}return v}}return[l,c,f]}var[T1,E1,A1]=C_(1),[C1,R1,P1]=C_(.001);el(2,-53,53,[1]);function q0(i,t){return i.map(e=>e.map((n,s)=>s==0||s==8||n==null?n:t(s==1||e[8]==0?n:e[1]+n)))}function $0(i,t){return(e,n,s,r,o)=>{let a=t.find(p=>o>=p[0])||t[t.length-1],l,c,f,u,h,d;return n.map(p=>{let _=i(p),g=_.getFullYear(),m=_.getMonth(),v=_.getDate(),A=_.getHours(),S=_.getMinutes(),R=_.getSeconds(),E=g!=l&&a[2]||m!=c&&a[3]||v!=f&&a[4]||A!=u&&a[5]||S!=h&&a[6]||R!=d&&a[7]||a[1];return l=g,c=m,f=v,u=A,h=S,d=R,E(_)})}}function I1(i,t){let e=Dd(t);return(n,s,r,o,a)=>s.map(l=>e(i(l)))}function dd(i,t,e){return new Date(i,t,e)}function Y0(i,t){return t(i)}var L1="{YYYY}-{MM}-{DD} {h}:{mm}{aa}";function Z0(i,t){return(e,n,s,r)=>r==null?Ad:t(i(n))}function D1(i,t){let e=i.series[t];return e.width?e.stroke(i,t):e.points.width?e.points.stroke(i,t):null}function N1(i,t){return i.series[t].fill(i,t)}var U1={show:!0,live:!0,isolate:!1,mount:t1,markers:{show:!0,width:2,stroke:D1,fill:N1,dash:"solid"},idx:null,idxs:null,values:[]};function F1(i,t){let e=i.cursor.points,n=Ai(),s=e.size(i,t);Je(n,Ja,s),Je(n,Ka,s);let r=s/-2;Je(n,"marginLeft",r),Je(n,"marginTop",r);let o=e.width(i,t,s);return o&&Je(n,"borderWidth",o),n}function O1(i,t){let e=i.series[t].points;return e._fill||e._stroke}function B1(i,t){let e=i.series[t].points;return e._stroke||e._fill}function k1(i,t){return i.series[t].points.size}var pd=[0,0];function z1(i,t,e){return pd[0]=t,pd[1]=e,pd}function Jh(i,t,e,n=!0){return s=>{s.button==0&&(!n||s.target==t)&&e(s)}}function md(i,t,e,n=!0){return s=>{(!n||s.target==t)&&e(s)}}var V1={show:!0,x:!0,y:!0,lock:!1,move:z1,points:{one:!1,show:F1,size:k1,width:0,stroke:B1,fill:O1},bind:{mousedown:Jh,mouseup:Jh,click:Jh,dblclick:Jh,mousemove:md,mouseleave:md,mouseenter:md},drag:{setScale:!0,x:!0,y:!1,dist:0,uni:null,click:(i,t)=>{t.stopPropagation(),t.stopImmediatePropagation()},_x:!1,_y:!1},focus:{dist:(i,t,e,n,s)=>n-s,prox:-1,bias:0},hover:{skip:[void 0],prox:null,bias:0},left:-10,top:-10,idx:null,dataIdx:null,idxs:null,event:null},R_={show:!0,stroke:"rgba(0,0,0,0.07)",width:2},Ud=xn({},R_,{filter:m_}),P_=xn({},Ud,{size:10}),I_=xn({},R_,{show:!1}),Fd='12px system-ui, -apple-system, "Segoe UI", Roboto, "Helvetica Neue", Arial, "Noto Sans", sans-serif, "Apple Color Emoji", "Segoe UI Emoji", "Segoe UI Symbol", "Noto Color Emoji"',L_="bold "+Fd,D_=1.5,J0={show:!0,scale:"x",stroke:Ed,space:50,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:L_,side:2,grid:Ud,ticks:P_,border:I_,font:Fd,lineGap:D_,rotate:0},G1="Value",H1="Time",K0={show:!0,scale:"x",auto:!1,sorted:1,min:Ve,max:-Ve,idxs:[]};function W1(i,t,e,n,s){return t.map(r=>r==null?"":Id(r))}function X1(i,t,e,n,s,r,o){let a=[],l=nr.get(s)||0;e=o?e:Ge(iu(e,s),l);for(let c=e;c<=n;c=Ge(c+s,l))a.push(Object.is(c,-0)?0:c);return a}function Sd(i,t,e,n,s,r,o){let a=[],l=i.scales[i.axes[t].scale].log,c=l==10?Rs:f_,f=vi(c(e));s=Lo(l,f),l==10&&(s=wr[Hi(s,wr)]);let u=e,h=s*l;l==10&&(h=wr[Hi(h,wr)]);do a.push(u),u=u+s,l==10&&!nr.has(u)&&(u=Ge(u,nr.get(s))),u>=h&&(s=u,h=s*l,l==10&&(h=wr[Hi(h,wr)]));while(u<=n);return a}function q1(i,t,e,n,s,r,o){let l=i.scales[i.axes[t].scale].asinh,c=n>l?Sd(i,t,ni(l,e),n,s):[l],f=n>=0&&e<=0?[0]:[];return(e<-l?Sd(i,t,ni(l,-n),-e,s):[l]).reverse().map(h=>-h).concat(f,c)}var N_=/./,$1=/[12357]/,Y1=/[125]/,j0=/1/,Md=(i,t,e,n)=>i.map((s,r)=>t==4&&s==0||r%n==0&&e.test(s.toExponential()[s<0?1:0])?s:null);function Z1(i,t,e,n,s){let r=i.axes[e],o=r.scale,a=i.scales[o],l=i.valToPos,c=r._space,f=l(10,o),u=l(9,o)-f>=c?N_:l(7,o)-f>=c?$1:l(5,o)-f>=c?Y1:j0;if(u==j0){let h=Cn(l(1,o)-f);if(h<c)return Md(t.slice().reverse(),a.distr,u,Ci(c/h)).reverse()}return Md(t,a.distr,u,1)}function J1(i,t,e,n,s){let r=i.axes[e],o=r.scale,a=r._space,l=i.valToPos,c=Cn(l(1,o)-l(2,o));return c<a?Md(t.slice().reverse(),3,N_,Ci(a/c)).reverse():t}function K1(i,t,e,n){return n==null?Ad:t==null?"":Id(t)}var Q0={show:!0,scale:"y",stroke:Ed,space:30,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:L_,side:3,grid:Ud,ticks:P_,border:I_,font:Fd,lineGap:D_,rotate:0};function j1(i,t){let e=3+(i||1)*2;return Ge(e*t,3)}function Q1(i,t){let{scale:e,idxs:n}=i.series[0],s=i._data[0],r=i.valToPos(s[n[0]],e,!0),o=i.valToPos(s[n[1]],e,!0),a=Cn(o-r),l=i.series[t],c=a/(l.points.space*Ie);return n[1]-n[0]<=c}var t_={scale:null,auto:!0,sorted:0,min:Ve,max:-Ve},U_=(i,t,e,n,s)=>s,e_={show:!0,auto:!0,sorted:0,gaps:U_,alpha:1,facets:[xn({},t_,{scale:"x"}),xn({},t_,{scale:"y"})]},n_={scale:"y",auto:!0,sorted:0,show:!0,spanGaps:!1,gaps:U_,alpha:1,points:{show:Q1,filter:null},values:null,min:Ve,max:-Ve,idxs:[],path:null,clip:null};function tA(i,t,e,n,s){return e/10}var F_={time:!0,auto:!0,distr:1,log:10,asinh:1,min:null,max:null,dir:1,ori:0},eA=xn({},F_,{time:!1,ori:1}),i_={};function O_(i,t){let e=i_[i];return e||(e={key:i,plots:[],sub(n){e.plots.push(n)},unsub(n){e.plots=e.plots.filter(s=>s!=n)},pub(n,s,r,o,a,l,c){for(let f=0;f<e.plots.length;f++)e.plots[f]!=s&&e.plots[f].pub(n,s,r,o,a,l,c)}},i!=null&&(i_[i]=e)),e}var Uo=1,bd=2;function Cr(i,t,e){let n=i.mode,s=i.series[t],r=n==2?i._data[t]:i._data,o=i.scales,a=i.bbox,l=r[0],c=n==2?r[1]:r[t],f=n==2?o[s.facets[0].scale]:o[i.series[0].scale],u=n==2?o[s.facets[1].scale]:o[s.scale],h=a.left,d=a.top,p=a.width,_=a.height,g=i.valToPosH,m=i.valToPosV;return f.ori==0?e(s,l,c,f,u,g,m,h,d,p,_,ou,Oo,lu,k_,V_):e(s,l,c,f,u,m,g,d,h,_,p,au,Bo,kd,z_,G_)}function Od(i,t){let e=0,n=0,s=Ae(i.bands,Ld);for(let r=0;r<s.length;r++){let o=s[r];o.series[0]==t?e=o.dir:o.series[1]==t&&(o.dir==1?n|=1:n|=2)}return[e,n==1?-1:n==2?1:n==3?2:0]}function nA(i,t,e,n,s){let r=i.mode,o=i.series[t],a=r==2?o.facets[1].scale:o.scale,l=i.scales[a];return s==-1?l.min:s==1?l.max:l.distr==3?l.dir==1?l.min:l.max:0}function Ps(i,t,e,n,s,r){return Cr(i,t,(o,a,l,c,f,u,h,d,p,_,g)=>{let m=o.pxRound,v=c.dir*(c.ori==0?1:-1),A=c.ori==0?Oo:Bo,S,R;v==1?(S=e,R=n):(S=n,R=e);let E=m(u(a[S],c,_,d)),x=m(h(l[S],f,g,p)),T=m(u(a[R],c,_,d)),U=m(h(r==1?f.max:f.min,f,g,p)),N=new Path2D(s);return A(N,T,U),A(N,E,U),A(N,E,x),N})}function ru(i,t,e,n,s,r){let o=null;if(i.length>0){o=new Path2D;let a=t==0?lu:kd,l=e;for(let u=0;u<i.length;u++){let h=i[u];if(h[1]>h[0]){let d=h[0]-l;d>0&&a(o,l,n,d,n+r),l=h[1]}}let c=e+s-l,f=10;c>0&&a(o,l,n-f/2,c,n+r+f)}return o}function iA(i,t,e){let n=i[i.length-1];n&&n[0]==t?n[1]=e:i.push([t,e])}function Bd(i,t,e,n,s,r,o){let a=[],l=i.length;for(let c=s==1?e:n;c>=e&&c<=n;c+=s)if(t[c]===null){let u=c,h=c;if(s==1)for(;++c<=n&&t[c]===null;)h=c;else for(;--c>=e&&t[c]===null;)h=c;let d=r(i[u]),p=h==u?d:r(i[h]),_=u-s;d=o<=0&&_>=0&&_<l?r(i[_]):d;let m=h+s;p=o>=0&&m>=0&&m<l?r(i[m]):p,p>=d&&a.push([d,p])}return a}function s_(i){return i==0?p_:i==1?An:t=>br(t,i)}function B_(i){let t=i==0?ou:au,e=i==0?(s,r,o,a,l,c)=>{s.arcTo(r,o,a,l,c)}:(s,r,o,a,l,c)=>{s.arcTo(o,r,l,a,c)},n=i==0?(s,r,o,a,l)=>{s.rect(r,o,a,l)}:(s,r,o,a,l)=>{s.rect(o,r,l,a)};return(s,r,o,a,l,c=0,f=0)=>{c==0&&f==0?n(s,r,o,a,l):(c=Wi(c,a/2,l/2),f=Wi(f,a/2,l/2),t(s,r+c,o),e(s,r+a,o,r+a,o+l,c),e(s,r+a,o+l,r,o+l,f),e(s,r,o+l,r,o,f),e(s,r,o,r+a,o,c),s.closePath())}}var ou=(i,t,e)=>{i.moveTo(t,e)},au=(i,t,e)=>{i.moveTo(e,t)},Oo=(i,t,e)=>{i.lineTo(t,e)},Bo=(i,t,e)=>{i.lineTo(e,t)},lu=B_(0),kd=B_(1),k_=(i,t,e,n,s,r)=>{i.arc(t,e,n,s,r)},z_=(i,t,e,n,s,r)=>{i.arc(e,t,n,s,r)},V_=(i,t,e,n,s,r,o)=>{i.bezierCurveTo(t,e,n,s,r,o)},G_=(i,t,e,n,s,r,o)=>{i.bezierCurveTo(e,t,s,n,o,r)};function H_(i){return(t,e,n,s,r)=>Cr(t,e,(o,a,l,c,f,u,h,d,p,_,g)=>{let{pxRound:m,points:v}=o,A,S;c.ori==0?(A=ou,S=k_):(A=au,S=z_);let R=Ge(v.width*Ie,3),E=(v.size-v.width)/2*Ie,x=Ge(E*2,3),T=new Path2D,U=new Path2D,{left:N,top:L,width:z,height:O}=t.bbox;lu(U,N-x,L-x,z+x*2,O+x*2);let P=G=>{if(l[G]!=null){let q=m(u(a[G],c,_,d)),H=m(h(l[G],f,g,p));A(T,q+E,H),S(T,q,H,E,0,Kh*2)}};if(r)r.forEach(P);else for(let G=n;G<=s;G++)P(G);return{stroke:R>0?T:null,fill:T,clip:U,flags:Uo|bd}})}function W_(i){return(t,e,n,s,r,o)=>{n!=s&&(r!=n&&o!=n&&i(t,e,n),r!=s&&o!=s&&i(t,e,s),i(t,e,o))}}var sA=W_(Oo),rA=W_(Bo);function X_(i){let t=Ae(i?.alignGaps,0);return(e,n,s,r)=>Cr(e,n,(o,a,l,c,f,u,h,d,p,_,g)=>{[s,r]=eu(l,s,r);let m=o.pxRound,v=O=>m(u(O,c,_,d)),A=O=>m(h(O,f,g,p)),S,R;c.ori==0?(S=Oo,R=sA):(S=Bo,R=rA);let E=c.dir*(c.ori==0?1:-1),x={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:Uo},T=x.stroke,U=!1;if(r-s>=_*4){let O=dt=>e.posToVal(dt,c.key,!0),P=null,G=null,q,H,ct,K=v(a[E==1?s:r]),et=v(a[s]),st=v(a[r]),pt=O(E==1?et+1:st-1);for(let dt=E==1?s:r;dt>=s&&dt<=r;dt+=E){let Q=a[dt],vt=(E==1?Q<pt:Q>pt)?K:v(Q),Pt=l[dt];vt==K?Pt!=null?(H=Pt,P==null?(S(T,vt,A(H)),q=P=G=H):H<P?P=H:H>G&&(G=H)):Pt===null&&(U=!0):(P!=null&&R(T,K,A(P),A(G),A(q),A(H)),Pt!=null?(H=Pt,S(T,vt,A(H)),P=G=q=H):(P=G=null,Pt===null&&(U=!0)),K=vt,pt=O(K+E))}P!=null&&P!=G&&ct!=K&&R(T,K,A(P),A(G),A(q),A(H))}else for(let O=E==1?s:r;O>=s&&O<=r;O+=E){let P=l[O];P===null?U=!0:P!=null&&S(T,v(a[O]),A(P))}let[L,z]=Od(e,n);if(o.fill!=null||L!=0){let O=x.fill=new Path2D(T),P=o.fillTo(e,n,o.min,o.max,L),G=A(P),q=v(a[s]),H=v(a[r]);E==-1&&([H,q]=[q,H]),S(O,H,G),S(O,q,G)}if(!o.spanGaps){let O=[];U&&O.push(...Bd(a,l,s,r,E,v,t)),x.gaps=O=o.gaps(e,n,s,r,O),x.clip=ru(O,c.ori,d,p,_,g)}return z!=0&&(x.band=z==2?[Ps(e,n,s,r,T,-1),Ps(e,n,s,r,T,1)]:Ps(e,n,s,r,T,z)),x})}function oA(i){let t=Ae(i.align,1),e=Ae(i.ascDesc,!1),n=Ae(i.alignGaps,0),s=Ae(i.extend,!1);return(r,o,a,l)=>Cr(r,o,(c,f,u,h,d,p,_,g,m,v,A)=>{[a,l]=eu(u,a,l);let S=c.pxRound,{left:R,width:E}=r.bbox,x=et=>S(p(et,h,v,g)),T=et=>S(_(et,d,A,m)),U=h.ori==0?Oo:Bo,N={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:Uo},L=N.stroke,z=h.dir*(h.ori==0?1:-1),O=T(u[z==1?a:l]),P=x(f[z==1?a:l]),G=P,q=P;s&&t==-1&&(q=R,U(L,q,O)),U(L,P,O);for(let et=z==1?a:l;et>=a&&et<=l;et+=z){let st=u[et];if(st==null)continue;let pt=x(f[et]),dt=T(st);t==1?U(L,pt,O):U(L,G,dt),U(L,pt,dt),O=dt,G=pt}let H=G;s&&t==1&&(H=R+E,U(L,H,O));let[ct,K]=Od(r,o);if(c.fill!=null||ct!=0){let et=N.fill=new Path2D(L),st=c.fillTo(r,o,c.min,c.max,ct),pt=T(st);U(et,H,pt),U(et,q,pt)}if(!c.spanGaps){let et=[];et.push(...Bd(f,u,a,l,z,x,n));let st=c.width*Ie/2,pt=e||t==1?st:-st,dt=e||t==-1?-st:st;et.forEach(Q=>{Q[0]+=pt,Q[1]+=dt}),N.gaps=et=c.gaps(r,o,a,l,et),N.clip=ru(et,h.ori,g,m,v,A)}return K!=0&&(N.band=K==2?[Ps(r,o,a,l,L,-1),Ps(r,o,a,l,L,1)]:Ps(r,o,a,l,L,K)),N})}function r_(i,t,e,n,s,r,o=Ve){if(i.length>1){let a=null;for(let l=0,c=1/0;l<i.length;l++)if(t[l]!==void 0){if(a!=null){let f=Cn(i[l]-i[a]);f<c&&(c=f,o=Cn(e(i[l],n,s,r)-e(i[a],n,s,r)))}a=l}}return o}function aA(i){i=i||tl;let t=Ae(i.size,[.6,Ve,1]),e=i.align||0,n=i.gap||0,s=i.radius;s=s==null?[0,0]:typeof s=="number"?[s,0]:s;let r=be(s),o=1-t[0],a=Ae(t[1],Ve),l=Ae(t[2],1),c=Ae(i.disp,tl),f=Ae(i.each,d=>{}),{fill:u,stroke:h}=c;return(d,p,_,g)=>Cr(d,p,(m,v,A,S,R,E,x,T,U,N,L)=>{let z=m.pxRound,O=e,P=n*Ie,G=a*Ie,q=l*Ie,H,ct;S.ori==0?[H,ct]=r(d,p):[ct,H]=r(d,p);let K=S.dir*(S.ori==0?1:-1),et=S.ori==0?lu:kd,st=S.ori==0?f:(Lt,Qt,he,Et,ze,Wt,Kt)=>{f(Lt,Qt,he,ze,Et,Kt,Wt)},pt=Ae(d.bands,Ld).find(Lt=>Lt.series[0]==p),dt=pt!=null?pt.dir:0,Q=m.fillTo(d,p,m.min,m.max,dt),_t=z(x(Q,R,L,U)),vt,Pt,Tt,Yt=N,ce=z(m.width*Ie),Xt=!1,ge=null,de=null,ae=null,Ke=null;u!=null&&(ce==0||h!=null)&&(Xt=!0,ge=u.values(d,p,_,g),de=new Map,new Set(ge).forEach(Lt=>{Lt!=null&&de.set(Lt,new Path2D)}),ce>0&&(ae=h.values(d,p,_,g),Ke=new Map,new Set(ae).forEach(Lt=>{Lt!=null&&Ke.set(Lt,new Path2D)})));let{x0:He,size:un}=c;if(He!=null&&un!=null){O=1,v=He.values(d,p,_,g),He.unit==2&&(v=v.map(he=>d.posToVal(T+he*N,S.key,!0)));let Lt=un.values(d,p,_,g);un.unit==2?Pt=Lt[0]*N:Pt=E(Lt[0],S,N,T)-E(0,S,N,T),Yt=r_(v,A,E,S,N,T,Yt),Tt=Yt-Pt+P}else Yt=r_(v,A,E,S,N,T,Yt),Tt=Yt*o+P,Pt=Yt-Tt;Tt<1&&(Tt=0),ce>=Pt/2&&(ce=0),Tt<5&&(z=p_);let Be=Tt>0,Rn=Yt-Tt-(Be?ce:0);Pt=z(vd(Rn,q,G)),vt=(O==0?Pt/2:O==K?0:Pt)-O*K*((O==0?P/2:0)+(Be?ce/2:0));let we={stroke:null,fill:null,clip:null,band:null,gaps:null,flags:0},yn=Xt?null:new Path2D,en=null;if(pt!=null)en=d.data[pt.series[1]];else{let{y0:Lt,y1:Qt}=c;Lt!=null&&Qt!=null&&(A=Qt.values(d,p,_,g),en=Lt.values(d,p,_,g))}let fn=H*Pt,k=ct*Pt;for(let Lt=K==1?_:g;Lt>=_&&Lt<=g;Lt+=K){let Qt=A[Lt];if(Qt==null)continue;if(en!=null){let $=en[Lt]??0;if(Qt-$==0)continue;_t=x($,R,L,U)}let he=S.distr!=2||c!=null?v[Lt]:Lt,Et=E(he,S,N,T),ze=x(Ae(Qt,Q),R,L,U),Wt=z(Et-vt),Kt=z(ni(ze,_t)),I=z(Wi(ze,_t)),M=Kt-I;if(Qt!=null){let $=Qt<0?k:fn,ft=Qt<0?fn:k;Xt?(ce>0&&ae[Lt]!=null&&et(Ke.get(ae[Lt]),Wt,I+vi(ce/2),Pt,ni(0,M-ce),$,ft),ge[Lt]!=null&&et(de.get(ge[Lt]),Wt,I+vi(ce/2),Pt,ni(0,M-ce),$,ft)):et(yn,Wt,I+vi(ce/2),Pt,ni(0,M-ce),$,ft),st(d,p,Lt,Wt-ce/2,I,Pt+ce,M)}}return ce>0?we.stroke=Xt?Ke:yn:Xt||(we._fill=m.width==0?m._fill:m._stroke??m._fill,we.width=0),we.fill=Xt?de:yn,we})}function lA(i,t){let e=Ae(t?.alignGaps,0);return(n,s,r,o)=>Cr(n,s,(a,l,c,f,u,h,d,p,_,g,m)=>{[r,o]=eu(c,r,o);let v=a.pxRound,A=H=>v(h(H,f,g,p)),S=H=>v(d(H,u,m,_)),R,E,x;f.ori==0?(R=ou,x=Oo,E=V_):(R=au,x=Bo,E=G_);let T=f.dir*(f.ori==0?1:-1),U=A(l[T==1?r:o]),N=U,L=[],z=[];for(let H=T==1?r:o;H>=r&&H<=o;H+=T)if(c[H]!=null){let K=l[H],et=A(K);L.push(N=et),z.push(S(c[H]))}let O={stroke:i(L,z,R,x,E,v),fill:null,clip:null,band:null,gaps:null,flags:Uo},P=O.stroke,[G,q]=Od(n,s);if(a.fill!=null||G!=0){let H=O.fill=new Path2D(P),ct=a.fillTo(n,s,a.min,a.max,G),K=S(ct);x(H,N,K),x(H,U,K)}if(!a.spanGaps){let H=[];H.push(...Bd(l,c,r,o,T,A,e)),O.gaps=H=a.gaps(n,s,r,o,H),O.clip=ru(H,f.ori,p,_,g,m)}return q!=0&&(O.band=q==2?[Ps(n,s,r,o,P,-1),Ps(n,s,r,o,P,1)]:Ps(n,s,r,o,P,q)),O})}function cA(i){return lA(hA,i)}function hA(i,t,e,n,s,r){let o=i.length;if(o<2)return null;let a=new Path2D;if(e(a,i[0],t[0]),o==2)n(a,i[1],t[1]);else{let l=Array(o),c=Array(o-1),f=Array(o-1),u=Array(o-1);for(let h=0;h<o-1;h++)f[h]=t[h+1]-t[h],u[h]=i[h+1]-i[h],c[h]=f[h]/u[h];l[0]=c[0];for(let h=1;h<o-1;h++)c[h]===0||c[h-1]===0||c[h-1]>0!=c[h]>0?l[h]=0:(l[h]=3*(u[h-1]+u[h])/((2*u[h]+u[h-1])/c[h-1]+(u[h]+2*u[h-1])/c[h]),isFinite(l[h])||(l[h]=0));l[o-1]=c[o-2];for(let h=0;h<o-1;h++)s(a,i[h]+u[h]/3,t[h]+l[h]*u[h]/3,i[h+1]-u[h]/3,t[h+1]-l[h+1]*u[h]/3,i[h+1],t[h+1])}return a}var wd=new Set;function o_(){for(let i of wd)i.syncRect(!0)}Fo&&(Er(WE,Io,o_),Er(XE,Io,o_,!0),Er(jh,Io,()=>{kn.pxRatio=Ie}));var uA=X_(),fA=H_();function a_(i,t,e,n){return(n?[i[0],i[1]].concat(i.slice(2)):[i[0]].concat(i.slice(1))).map((r,o)=>Td(r,o,t,e))}function dA(i,t){return i.map((e,n)=>n==0?{}:xn({},t,e))}function Td(i,t,e,n){return xn({},t==0?e:n,i)}function q_(i,t,e){return t==null?Do:[t,e]}var pA=q_;function mA(i,t,e){return t==null?Do:Qh(t,e,Pd,!0)}function $_(i,t,e,n){return t==null?Do:nu(t,e,i.scales[n].log,!1)}var gA=$_;function Y_(i,t,e,n){return t==null?Do:Rd(t,e,i.scales[n].log,!1)}var _A=Y_;function xA(i,t,e,n,s){let r=ni(k0(i),k0(t)),o=t-i,a=Hi(s/n*o,e);do{let l=e[a],c=n*l/o;if(c>=s&&r+(l<5?nr.get(l):0)<=17)return[l,c]}while(++a<e.length);return[0,0]}function l_(i){let t,e;return i=i.replace(/(\d+)px/,(n,s)=>(t=An((e=+s)*Ie))+"px"),[i,t,e]}function yA(i){i.show&&[i.font,i.labelFont].forEach(t=>{let e=Ge(t[2]*Ie,1);t[0]=t[0].replace(/[0-9.]+px/,e+"px"),t[1]=e})}function kn(i,t,e){let n={mode:Ae(i.mode,1)},s=n.mode;function r(y,b,D,F){let W=b.valToPct(y);return F+D*(b.dir==-1?1-W:W)}function o(y,b,D,F){let W=b.valToPct(y);return F+D*(b.dir==-1?W:1-W)}function a(y,b,D,F){return b.ori==0?r(y,b,D,F):o(y,b,D,F)}n.valToPosH=r,n.valToPosV=o;let l=!1;n.status=0;let c=n.root=Ai(EE);if(i.id!=null&&(c.id=i.id),yi(c,i.class),i.title){let y=Ai(RE,c);y.textContent=i.title}let f=Gi("canvas"),u=n.ctx=f.getContext("2d"),h=Ai(PE,c);Er("click",h,y=>{y.target===p&&(qe!=Fr||je!=Or)&&On.click(n,y)},!0);let d=n.under=Ai(IE,h);h.appendChild(f);let p=n.over=Ai(LE,h);i=No(i);let _=+Ae(i.pxAlign,1),g=s_(_);(i.plugins||[]).forEach(y=>{y.opts&&(i=y.opts(n,i)||i)});let m=i.ms||.001,v=n.series=s==1?a_(i.series||[],K0,n_,!1):dA(i.series||[null],e_),A=n.axes=a_(i.axes||[],J0,Q0,!0),S=n.scales={},R=n.bands=i.bands||[];R.forEach(y=>{y.fill=be(y.fill||null),y.dir=Ae(y.dir,-1)});let E=s==2?v[1].facets[0].scale:v[0].scale,x={axes:ps,series:xe},T=(i.drawOrder||["axes","series"]).map(y=>x[y]);function U(y){let b=y.distr==3?D=>Rs(D>0?D:y.clamp(n,D,y.min,y.max,y.key)):y.distr==4?D=>fd(D,y.asinh):y.distr==100?D=>y.fwd(D):D=>D;return D=>{let F=b(D),{_min:W,_max:j}=y,lt=j-W;return(F-W)/lt}}function N(y){let b=S[y];if(b==null){let D=(i.scales||tl)[y]||tl;if(D.from!=null){N(D.from);let F=xn({},S[D.from],D,{key:y});F.valToPct=U(F),S[y]=F}else{b=S[y]=xn({},y==E?F_:eA,D),b.key=y;let F=b.time,W=b.range,j=er(W);if((y!=E||s==2&&!F)&&(j&&(W[0]==null||W[1]==null)&&(W={min:W[0]==null?F0:{mode:1,hard:W[0],soft:W[0]},max:W[1]==null?F0:{mode:1,hard:W[1],soft:W[1]}},j=!1),!j&&su(W))){let lt=W;W=(mt,Mt,Ft)=>Mt==null?Do:Qh(Mt,Ft,lt)}b.range=be(W||(F?pA:y==E?b.distr==3?gA:b.distr==4?_A:q_:b.distr==3?$_:b.distr==4?Y_:mA)),b.auto=be(j?!1:b.auto),b.clamp=be(b.clamp||tA),b._min=b._max=null,b.valToPct=U(b)}}}N("x"),N("y"),s==1&&v.forEach(y=>{N(y.scale)}),A.forEach(y=>{N(y.scale)});for(let y in i.scales)N(y);let L=S[E],z=L.distr,O,P;L.ori==0?(yi(c,AE),O=r,P=o):(yi(c,CE),O=o,P=r);let G={};for(let y in S){let b=S[y];(b.min!=null||b.max!=null)&&(G[y]={min:b.min,max:b.max},b.min=b.max=null)}let q=i.tzDate||(y=>new Date(An(y/m))),H=i.fmtDate||Dd,ct=m==1?A1(q):P1(q),K=$0(q,q0(m==1?E1:R1,H)),et=Z0(q,Y0(L1,H)),st=[],pt=n.legend=xn({},U1,i.legend),dt=n.cursor=xn({},V1,{drag:{y:s==2}},i.cursor),Q=pt.show,_t=dt.show,vt=pt.markers;pt.idxs=st,vt.width=be(vt.width),vt.dash=be(vt.dash),vt.stroke=be(vt.stroke),vt.fill=be(vt.fill);let Pt,Tt,Yt,ce=[],Xt=[],ge,de=!1,ae={};if(pt.live){let y=v[1]?v[1].values:null;de=y!=null,ge=de?y(n,1,0):{_:0};for(let b in ge)ae[b]=Ad}if(Q)if(Pt=Gi("table",BE,c),Yt=Gi("tbody",null,Pt),pt.mount(n,Pt),de){Tt=Gi("thead",null,Pt,Yt);let y=Gi("tr",null,Tt);Gi("th",null,y);for(var Ke in ge)Gi("th",b0,y).textContent=Ke}else yi(Pt,zE),pt.live&&yi(Pt,kE);let He={show:!0},un={show:!1};function Be(y,b){if(b==0&&(de||!pt.live||s==2))return Do;let D=[],F=Gi("tr",VE,Yt,Yt.childNodes[b]);yi(F,y.class),y.show||yi(F,Tr);let W=Gi("th",null,F);if(vt.show){let mt=Ai(GE,W);if(b>0){let Mt=vt.width(n,b);Mt&&(mt.style.border=Mt+"px "+vt.dash(n,b)+" "+vt.stroke(n,b)),mt.style.background=vt.fill(n,b)}}let j=Ai(b0,W);y.label instanceof HTMLElement?j.appendChild(y.label):j.textContent=y.label,b>0&&(vt.show||(j.style.color=y.width>0?vt.stroke(n,b):vt.fill(n,b)),we("click",W,mt=>{if(dt._lock)return;ne(mt);let Mt=v.indexOf(y);if((mt.ctrlKey||mt.metaKey)!=pt.isolate){let Ft=v.some((Ot,kt)=>kt>0&&kt!=Mt&&Ot.show);v.forEach((Ot,kt)=>{kt>0&&Yi(kt,Ft?kt==Mt?He:un:He,!0,gn.setSeries)})}else Yi(Mt,{show:!y.show},!0,gn.setSeries)},!1),ie&&we(A0,W,mt=>{dt._lock||(ne(mt),Yi(v.indexOf(y),kr,!0,gn.setSeries))},!1));for(var lt in ge){let mt=Gi("td",HE,F);mt.textContent="--",D.push(mt)}return[F,D]}let Rn=new Map;function we(y,b,D,F=!0){let W=Rn.get(b)||{},j=dt.bind[y](n,b,D,F);j&&(Er(y,b,W[y]=j),Rn.set(b,W))}function yn(y,b,D){let F=Rn.get(b)||{};for(let W in F)(y==null||W==y)&&(yd(W,b,F[W]),delete F[W]);y==null&&Rn.delete(b)}let en=0,fn=0,k=0,Lt=0,Qt=0,he=0,Et=Qt,ze=he,Wt=k,Kt=Lt,I=0,M=0,$=0,ft=0;n.bbox={};let at=!1,yt=!1,St=!1,nt=!1,rt=!1,gt=!1;function B(y,b,D){(D||y!=n.width||b!=n.height)&&ot(y,b),pe(!1),St=!0,yt=!0,zn()}function ot(y,b){n.width=en=k=y,n.height=fn=Lt=b,Qt=he=0,wt(),qt();let D=n.bbox;I=D.left=br(Qt*Ie,.5),M=D.top=br(he*Ie,.5),$=D.width=br(k*Ie,.5),ft=D.height=br(Lt*Ie,.5)}let it=3;function At(){let y=!1,b=0;for(;!y;){b++;let D=Dr(b),F=$i(b);y=b==it||D&&F,y||(ot(n.width,n.height),yt=!0)}}function xt({width:y,height:b}){B(y,b)}n.setSize=xt;function wt(){let y=!1,b=!1,D=!1,F=!1;A.forEach((W,j)=>{if(W.show&&W._show){let{side:lt,_size:mt}=W,Mt=lt%2,Ft=W.label!=null?W.labelSize:0,Ot=mt+Ft;Ot>0&&(Mt?(k-=Ot,lt==3?(Qt+=Ot,F=!0):D=!0):(Lt-=Ot,lt==0?(he+=Ot,y=!0):b=!0))}}),Xi[0]=y,Xi[1]=D,Xi[2]=b,Xi[3]=F,k-=Ri[1]+Ri[3],Qt+=Ri[3],Lt-=Ri[2]+Ri[0],he+=Ri[0]}function qt(){let y=Qt+k,b=he+Lt,D=Qt,F=he;function W(j,lt){switch(j){case 1:return y+=lt,y-lt;case 2:return b+=lt,b-lt;case 3:return D-=lt,D+lt;case 0:return F-=lt,F+lt}}A.forEach((j,lt)=>{if(j.show&&j._show){let mt=j.side;j._pos=W(mt,j._size),j.label!=null&&(j._lpos=W(mt,j.labelSize))}})}if(dt.dataIdx==null){let y=dt.hover,b=y.skip=new Set(y.skip??[]);b.add(void 0);let D=y.prox=be(y.prox),F=y.bias??=0;dt.dataIdx=(W,j,lt,mt)=>{if(j==0)return lt;let Mt=lt,Ft=D(W,j,lt,mt)??Ve,Ot=Ft>=0&&Ft<Ve,kt=L.ori==0?k:Lt,le=dt.left,Ce=t[0],Ee=t[j];if(b.has(Ee[lt])){Mt=null;let ve=null,ee=null,Zt;if(F==0||F==-1)for(Zt=lt;ve==null&&Zt-- >0;)b.has(Ee[Zt])||(ve=Zt);if(F==0||F==1)for(Zt=lt;ee==null&&Zt++<Ee.length;)b.has(Ee[Zt])||(ee=Zt);if(ve!=null||ee!=null)if(Ot){let Ye=ve==null?-1/0:O(Ce[ve],L,kt,0),rn=ee==null?1/0:O(Ce[ee],L,kt,0),Dn=le-Ye,ke=rn-le;Dn<=ke?Dn<=Ft&&(Mt=ve):ke<=Ft&&(Mt=ee)}else Mt=ee==null?ve:ve==null?ee:lt-ve<=ee-lt?ve:ee}else Ot&&Cn(le-O(Ce[lt],L,kt,0))>Ft&&(Mt=null);return Mt}}let ne=y=>{dt.event=y};dt.idxs=st,dt._lock=!1;let ut=dt.points;ut.show=be(ut.show),ut.size=be(ut.size),ut.stroke=be(ut.stroke),ut.width=be(ut.width),ut.fill=be(ut.fill);let Vt=n.focus=xn({},i.focus||{alpha:.3},dt.focus),ie=Vt.prox>=0,It=ie&&ut.one,fe=[],Xe=[],Wn=[];function zo(y,b){let D=ut.show(n,b);if(D instanceof HTMLElement)return yi(D,OE),yi(D,y.class),hs(D,-10,-10,k,Lt),p.insertBefore(D,fe[b]),D}function Pr(y,b){if(s==1||b>0){let D=s==1&&S[y.scale].time,F=y.value;y.value=D?G0(F)?Z0(q,Y0(F,H)):F||et:F||K1,y.label=y.label||(D?H1:G1)}if(It||b>0){y.width=y.width==null?1:y.width,y.paths=y.paths||uA||e1,y.fillTo=be(y.fillTo||nA),y.pxAlign=+Ae(y.pxAlign,_),y.pxRound=s_(y.pxAlign),y.stroke=be(y.stroke||null),y.fill=be(y.fill||null),y._stroke=y._fill=y._paths=y._focus=null;let D=j1(ni(1,y.width),1),F=y.points=xn({},{size:D,width:ni(1,D*.2),stroke:y.stroke,space:D*2,paths:fA,_stroke:null,_fill:null},y.points);F.show=be(F.show),F.filter=be(F.filter),F.fill=be(F.fill),F.stroke=be(F.stroke),F.paths=be(F.paths),F.pxAlign=y.pxAlign}if(Q){let D=Be(y,b);ce.splice(b,0,D[0]),Xt.splice(b,0,D[1]),pt.values.push(null)}if(_t){st.splice(b,0,null);let D=null;It?b==0&&(D=zo(y,b)):b>0&&(D=zo(y,b)),fe.splice(b,0,D),Xe.splice(b,0,0),Wn.splice(b,0,0)}Ln("addSeries",b)}function du(y,b){b=b??v.length,y=s==1?Td(y,b,K0,n_):Td(y,b,{},e_),v.splice(b,0,y),Pr(v[b],b)}n.addSeries=du;function sl(y){if(v.splice(y,1),Q){pt.values.splice(y,1),Xt.splice(y,1);let b=ce.splice(y,1)[0];yn(null,b.firstChild),b.remove()}_t&&(st.splice(y,1),fe.splice(y,1)[0].remove(),Xe.splice(y,1),Wn.splice(y,1)),Ln("delSeries",y)}n.delSeries=sl;let Xi=[!1,!1,!1,!1];function us(y,b){if(y._show=y.show,y.show){let D=y.side%2,F=S[y.scale];F==null&&(y.scale=D?v[1].scale:E,F=S[y.scale]);let W=F.time;y.size=be(y.size),y.space=be(y.space),y.rotate=be(y.rotate),er(y.incrs)&&y.incrs.forEach(lt=>{!nr.has(lt)&&nr.set(lt,__(lt))}),y.incrs=be(y.incrs||(F.distr==2?b1:W?m==1?T1:C1:wr)),y.splits=be(y.splits||(W&&F.distr==1?ct:F.distr==3?Sd:F.distr==4?q1:X1)),y.stroke=be(y.stroke),y.grid.stroke=be(y.grid.stroke),y.ticks.stroke=be(y.ticks.stroke),y.border.stroke=be(y.border.stroke);let j=y.values;y.values=er(j)&&!er(j[0])?be(j):W?er(j)?$0(q,q0(j,H)):G0(j)?I1(q,j):j||K:j||W1,y.filter=be(y.filter||(F.distr>=3&&F.log==10?Z1:F.distr==3&&F.log==2?J1:m_)),y.font=l_(y.font),y.labelFont=l_(y.labelFont),y._size=y.size(n,null,b,0),y._space=y._rotate=y._incrs=y._found=y._splits=y._values=null,y._size>0&&(Xi[b]=!0,y._el=Ai(DE,h))}}function fs(y,b,D,F){let[W,j,lt,mt]=D,Mt=b%2,Ft=0;return Mt==0&&(mt||j)&&(Ft=b==0&&!W||b==2&&!lt?An(J0.size/3):0),Mt==1&&(W||lt)&&(Ft=b==1&&!j||b==3&&!mt?An(Q0.size/2):0),Ft}let Vo=n.padding=(i.padding||[fs,fs,fs,fs]).map(y=>be(Ae(y,fs))),Ri=n._padding=Vo.map((y,b)=>y(n,b,Xi,0)),nn,cn=null,hn=null,qi=s==1?v[0].idxs:null,ci=null,Ns=!1;function Go(y,b){if(t=y??[],n.data=n._data=t,s==2){nn=0;for(let D=1;D<v.length;D++)nn+=t[D][0].length}else{t.length==0&&(n.data=n._data=t=[[]]),ci=t[0],nn=ci.length;let D=t;if(z==2){D=t.slice();let F=D[0]=Array(nn);for(let W=0;W<nn;W++)F[W]=W}n._data=t=D}if(pe(!0),Ln("setData"),z==2&&(St=!0),b!==!1){let D=L;D.auto(n,Ns)?Ho():Os(E,D.min,D.max),nt=nt||dt.left>=0,gt=!0,zn()}}n.setData=Go;function Ho(){Ns=!0;let y,b;s==1&&(nn>0?(cn=qi[0]=0,hn=qi[1]=nn-1,y=t[0][cn],b=t[0][hn],z==2?(y=cn,b=hn):y==b&&(z==3?[y,b]=nu(y,y,L.log,!1):z==4?[y,b]=Rd(y,y,L.log,!1):L.time?b=y+An(86400/m):[y,b]=Qh(y,b,Pd,!0))):(cn=qi[0]=y=null,hn=qi[1]=b=null)),Os(E,y,b)}let Ir,Us,Lr,w,V,tt,Z,J,Ct,Dt;function Rt(y,b,D,F,W,j){y??=T0,D??=Ld,F??="butt",W??=T0,j??="round",y!=Ir&&(u.strokeStyle=Ir=y),W!=Us&&(u.fillStyle=Us=W),b!=Lr&&(u.lineWidth=Lr=b),j!=V&&(u.lineJoin=V=j),F!=tt&&(u.lineCap=tt=F),D!=w&&u.setLineDash(w=D)}function Nt(y,b,D,F){b!=Us&&(u.fillStyle=Us=b),y!=Z&&(u.font=Z=y),D!=J&&(u.textAlign=J=D),F!=Ct&&(u.textBaseline=Ct=F)}function Ht(y,b,D,F,W=0){if(F.length>0&&y.auto(n,Ns)&&(b==null||b.min==null)){let j=Ae(cn,0),lt=Ae(hn,F.length-1),mt=D.min==null?ZE(F,j,lt,W,y.distr==3):[D.min,D.max];y.min=Wi(y.min,D.min=mt[0]),y.max=ni(y.max,D.max=mt[1])}}let re={min:null,max:null};function _e(){for(let F in S){let W=S[F];G[F]==null&&(W.min==null||G[E]!=null&&W.auto(n,Ns))&&(G[F]=re)}for(let F in S){let W=S[F];G[F]==null&&W.from!=null&&G[W.from]!=null&&(G[F]=re)}G[E]!=null&&pe(!0);let y={};for(let F in G){let W=G[F];if(W!=null){let j=y[F]=No(S[F],s1);if(W.min!=null)xn(j,W);else if(F!=E||s==2)if(nn==0&&j.from==null){let lt=j.range(n,null,null,F);j.min=lt[0],j.max=lt[1]}else j.min=Ve,j.max=-Ve}}if(nn>0){v.forEach((F,W)=>{if(s==1){let j=F.scale,lt=G[j];if(lt==null)return;let mt=y[j];if(W==0){let Mt=mt.range(n,mt.min,mt.max,j);mt.min=Mt[0],mt.max=Mt[1],cn=Hi(mt.min,t[0]),hn=Hi(mt.max,t[0]),hn-cn>1&&(t[0][cn]<mt.min&&cn++,t[0][hn]>mt.max&&hn--),F.min=ci[cn],F.max=ci[hn]}else F.show&&F.auto&&Ht(mt,lt,F,t[W],F.sorted);F.idxs[0]=cn,F.idxs[1]=hn}else if(W>0&&F.show&&F.auto){let[j,lt]=F.facets,mt=j.scale,Mt=lt.scale,[Ft,Ot]=t[W],kt=y[mt],le=y[Mt];kt!=null&&Ht(kt,G[mt],j,Ft,j.sorted),le!=null&&Ht(le,G[Mt],lt,Ot,lt.sorted),F.min=lt.min,F.max=lt.max}});for(let F in y){let W=y[F],j=G[F];if(W.from==null&&(j==null||j.min==null)){let lt=W.range(n,W.min==Ve?null:W.min,W.max==-Ve?null:W.max,F);W.min=lt[0],W.max=lt[1]}}}for(let F in y){let W=y[F];if(W.from!=null){let j=y[W.from];if(j.min==null)W.min=W.max=null;else{let lt=W.range(n,j.min,j.max,F);W.min=lt[0],W.max=lt[1]}}}let b={},D=!1;for(let F in y){let W=y[F],j=S[F];if(j.min!=W.min||j.max!=W.max){j.min=W.min,j.max=W.max;let lt=j.distr;j._min=lt==3?Rs(j.min):lt==4?fd(j.min,j.asinh):lt==100?j.fwd(j.min):j.min,j._max=lt==3?Rs(j.max):lt==4?fd(j.max,j.asinh):lt==100?j.fwd(j.max):j.max,b[F]=D=!0}}if(D){v.forEach((F,W)=>{s==2?W>0&&b.y&&(F._paths=null):b[F.scale]&&(F._paths=null)});for(let F in b)St=!0,Ln("setScale",F);_t&&dt.left>=0&&(nt=gt=!0)}for(let F in G)G[F]=null}function Gt(y){let b=vd(cn-1,0,nn-1),D=vd(hn+1,0,nn-1);for(;y[b]==null&&b>0;)b--;for(;y[D]==null&&D<nn-1;)D++;return[b,D]}function xe(){if(nn>0){let y=v.some(b=>b._focus)&&Dt!=Vt.alpha;y&&(u.globalAlpha=Dt=Vt.alpha),v.forEach((b,D)=>{if(D>0&&b.show&&(tn(D,!1),tn(D,!0),b._paths==null)){let F=Dt;Dt!=b.alpha&&(u.globalAlpha=Dt=b.alpha);let W=s==2?[0,t[D][0].length-1]:Gt(t[D]);b._paths=b.paths(n,D,W[0],W[1]),Dt!=F&&(u.globalAlpha=Dt=F)}}),v.forEach((b,D)=>{if(D>0&&b.show){let F=Dt;Dt!=b.alpha&&(u.globalAlpha=Dt=b.alpha),b._paths!=null&&Ue(D,!1);{let W=b._paths!=null?b._paths.gaps:null,j=b.points.show(n,D,cn,hn,W),lt=b.points.filter(n,D,j,W);(j||lt)&&(b.points._paths=b.points.paths(n,D,cn,hn,lt),Ue(D,!0))}Dt!=F&&(u.globalAlpha=Dt=F),Ln("drawSeries",D)}}),y&&(u.globalAlpha=Dt=1)}}function tn(y,b){let D=b?v[y].points:v[y];D._stroke=D.stroke(n,y),D._fill=D.fill(n,y)}function Ue(y,b){let D=b?v[y].points:v[y],{stroke:F,fill:W,clip:j,flags:lt,_stroke:mt=D._stroke,_fill:Mt=D._fill,_width:Ft=D.width}=D._paths;Ft=Ge(Ft*Ie,3);let Ot=null,kt=Ft%2/2;b&&Mt==null&&(Mt=Ft>0?"#fff":mt);let le=D.pxAlign==1&&kt>0;if(le&&u.translate(kt,kt),!b){let Ce=I-Ft/2,Ee=M-Ft/2,ve=$+Ft,ee=ft+Ft;Ot=new Path2D,Ot.rect(Ce,Ee,ve,ee)}b?Bt(mt,Ft,D.dash,D.cap,Mt,F,W,lt,j):Fe(y,mt,Ft,D.dash,D.cap,Mt,F,W,lt,Ot,j),le&&u.translate(-kt,-kt)}function Fe(y,b,D,F,W,j,lt,mt,Mt,Ft,Ot){let kt=!1;Mt!=0&&R.forEach((le,Ce)=>{if(le.series[0]==y){let Ee=v[le.series[1]],ve=t[le.series[1]],ee=(Ee._paths||tl).band;er(ee)&&(ee=le.dir==1?ee[0]:ee[1]);let Zt,Ye=null;Ee.show&&ee&&KE(ve,cn,hn)?(Ye=le.fill(n,Ce)||j,Zt=Ee._paths.clip):ee=null,Bt(b,D,F,W,Ye,lt,mt,Mt,Ft,Ot,Zt,ee),kt=!0}}),kt||Bt(b,D,F,W,j,lt,mt,Mt,Ft,Ot)}let vn=Uo|bd;function Bt(y,b,D,F,W,j,lt,mt,Mt,Ft,Ot,kt){Rt(y,b,D,F,W),(Mt||Ft||kt)&&(u.save(),Mt&&u.clip(Mt),Ft&&u.clip(Ft)),kt?(mt&vn)==vn?(u.clip(kt),Ot&&u.clip(Ot),Se(W,lt),dn(y,j,b)):mt&bd?(Se(W,lt),u.clip(kt),dn(y,j,b)):mt&Uo&&(u.save(),u.clip(kt),Ot&&u.clip(Ot),Se(W,lt),u.restore(),dn(y,j,b)):(Se(W,lt),dn(y,j,b)),(Mt||Ft||kt)&&u.restore()}function dn(y,b,D){D>0&&(b instanceof Map?b.forEach((F,W)=>{u.strokeStyle=Ir=W,u.stroke(F)}):b!=null&&y&&u.stroke(b))}function Se(y,b){b instanceof Map?b.forEach((D,F)=>{u.fillStyle=Us=F,u.fill(D)}):b!=null&&y&&u.fill(b)}function ds(y,b,D,F){let W=A[y],j;if(F<=0)j=[0,0];else{let lt=W._space=W.space(n,y,b,D,F),mt=W._incrs=W.incrs(n,y,b,D,F,lt);j=xA(b,D,mt,F,lt)}return W._found=j}function pn(y,b,D,F,W,j,lt,mt,Mt,Ft){let Ot=lt%2/2;_==1&&u.translate(Ot,Ot),Rt(mt,lt,Mt,Ft,mt),u.beginPath();let kt,le,Ce,Ee,ve=W+(F==0||F==3?-j:j);D==0?(le=W,Ee=ve):(kt=W,Ce=ve);for(let ee=0;ee<y.length;ee++)b[ee]!=null&&(D==0?kt=Ce=y[ee]:le=Ee=y[ee],u.moveTo(kt,le),u.lineTo(Ce,Ee));u.stroke(),_==1&&u.translate(-Ot,-Ot)}function Dr(y){let b=!0;return A.forEach((D,F)=>{if(!D.show)return;let W=S[D.scale];if(W.min==null){D._show&&(b=!1,D._show=!1,pe(!1));return}else D._show||(b=!1,D._show=!0,pe(!1));let j=D.side,lt=j%2,{min:mt,max:Mt}=W,[Ft,Ot]=ds(F,mt,Mt,lt==0?k:Lt);if(Ot==0)return;let kt=W.distr==2,le=D._splits=D.splits(n,F,mt,Mt,Ft,Ot,kt),Ce=W.distr==2?le.map(Zt=>ci[Zt]):le,Ee=W.distr==2?ci[le[1]]-ci[le[0]]:Ft,ve=D._values=D.values(n,D.filter(n,Ce,F,Ot,Ee),F,Ot,Ee);D._rotate=j==2?D.rotate(n,ve,F,Ot):0;let ee=D._size;D._size=Ci(D.size(n,ve,F,y)),ee!=null&&D._size!=ee&&(b=!1)}),b}function $i(y){let b=!0;return Vo.forEach((D,F)=>{let W=D(n,F,Xi,y);W!=Ri[F]&&(b=!1),Ri[F]=W}),b}function ps(){for(let y=0;y<A.length;y++){let b=A[y];if(!b.show||!b._show)continue;let D=b.side,F=D%2,W,j,lt=b.stroke(n,y),mt=D==0||D==3?-1:1,[Mt,Ft]=b._found;if(b.label!=null){let $n=b.labelGap*mt,fi=An((b._lpos+$n)*Ie);Nt(b.labelFont[0],lt,"center",D==2?"top":w0),u.save(),F==1?(W=j=0,u.translate(fi,An(M+ft/2)),u.rotate((D==3?-Kh:Kh)/2)):(W=An(I+$/2),j=fi);let ar=d_(b.label)?b.label(n,y,Mt,Ft):b.label;u.fillText(ar,W,j),u.restore()}if(Ft==0)continue;let Ot=S[b.scale],kt=F==0?$:ft,le=F==0?I:M,Ce=b._splits,Ee=Ot.distr==2?Ce.map($n=>ci[$n]):Ce,ve=Ot.distr==2?ci[Ce[1]]-ci[Ce[0]]:Mt,ee=b.ticks,Zt=b.border,Ye=ee.show?ee.size:0,rn=An(Ye*Ie),Dn=An((b.alignTo==2?b._size-Ye-b.gap:b.gap)*Ie),ke=b._rotate*-Kh/180,on=g(b._pos*Ie),hi=(rn+Dn)*mt,qn=on+hi;j=F==0?qn:0,W=F==1?qn:0;let Mi=b.font[0],Pi=b.align==1?Ro:b.align==2?cd:ke>0?Ro:ke<0?cd:F==0?"center":D==3?cd:Ro,Ji=ke||F==1?"middle":D==2?"top":w0;Nt(Mi,lt,Pi,Ji);let ui=b.font[1]*b.lineGap,bi=Ce.map($n=>g(a($n,Ot,kt,le))),Ii=b._values;for(let $n=0;$n<Ii.length;$n++){let fi=Ii[$n];if(fi!=null){F==0?W=bi[$n]:j=bi[$n],fi=""+fi;let ar=fi.indexOf(`
`)==-1?[fi]:fi.split(/\n/gm);for(let Yn=0;Yn<ar.length;Yn++){let pp=ar[Yn];ke?(u.save(),u.translate(W,j+Yn*ui),u.rotate(ke),u.fillText(pp,0,0),u.restore()):u.fillText(pp,W,j+Yn*ui)}}}ee.show&&pn(bi,ee.filter(n,Ee,y,Ft,ve),F,D,on,rn,Ge(ee.width*Ie,3),ee.stroke(n,y),ee.dash,ee.cap);let Ki=b.grid;Ki.show&&pn(bi,Ki.filter(n,Ee,y,Ft,ve),F,F==0?2:1,F==0?M:I,F==0?ft:$,Ge(Ki.width*Ie,3),Ki.stroke(n,y),Ki.dash,Ki.cap),Zt.show&&pn([on],[1],F==0?1:0,F==0?1:2,F==1?M:I,F==1?ft:$,Ge(Zt.width*Ie,3),Zt.stroke(n,y),Zt.dash,Zt.cap)}Ln("drawAxes")}function pe(y){v.forEach((b,D)=>{D>0&&(b._paths=null,y&&(s==1?(b.min=null,b.max=null):b.facets.forEach(F=>{F.min=null,F.max=null})))})}let sn=!1,Xn=!1,Oe=[];function mn(){Xn=!1;for(let y=0;y<Oe.length;y++)Ln(...Oe[y]);Oe.length=0}function zn(){sn||(u1(Jd),sn=!0)}function rl(y,b=!1){sn=!0,Xn=b,y(n),Jd(),b&&Oe.length>0&&queueMicrotask(mn)}n.batch=rl;function Jd(){if(at&&(_e(),at=!1),St&&(At(),St=!1),yt){if(Je(d,Ro,Qt),Je(d,"top",he),Je(d,Ja,k),Je(d,Ka,Lt),Je(p,Ro,Qt),Je(p,"top",he),Je(p,Ja,k),Je(p,Ka,Lt),Je(h,Ja,en),Je(h,Ka,fn),f.width=An(en*Ie),f.height=An(fn*Ie),A.forEach(({_el:y,_show:b,_size:D,_pos:F,side:W})=>{if(y!=null)if(b){let j=W===3||W===0?D:0,lt=W%2==1;Je(y,lt?"left":"top",F-j),Je(y,lt?"width":"height",D),Je(y,lt?"top":"left",lt?he:Qt),Je(y,lt?"height":"width",lt?Lt:k),xd(y,Tr)}else yi(y,Tr)}),Ir=Us=Lr=V=tt=Z=J=Ct=w=null,Dt=1,qo(!0),Qt!=Et||he!=ze||k!=Wt||Lt!=Kt){pe(!1);let y=k/Wt,b=Lt/Kt;if(_t&&!nt&&dt.left>=0){dt.left*=y,dt.top*=b,Nr&&hs(Nr,An(dt.left),0,k,Lt),Ur&&hs(Ur,0,An(dt.top),k,Lt);for(let D=0;D<fe.length;D++){let F=fe[D];F!=null&&(Xe[D]*=y,Wn[D]*=b,hs(F,Ci(Xe[D]),Ci(Wn[D]),k,Lt))}}if($e.show&&!rt&&$e.left>=0&&$e.width>0){$e.left*=y,$e.width*=y,$e.top*=b,$e.height*=b;for(let D in yu)Je(Br,D,$e[D])}Et=Qt,ze=he,Wt=k,Kt=Lt}Ln("setSize"),yt=!1}en>0&&fn>0&&(u.clearRect(0,0,f.width,f.height),Ln("drawClear"),T.forEach(y=>y()),Ln("draw")),$e.show&&rt&&(ol($e),rt=!1),_t&&nt&&(or(null,!0,!1),nt=!1),pt.show&&pt.live&&gt&&(_u(),gt=!1),l||(l=!0,n.status=1,Ln("ready")),Ns=!1,sn=!1}n.redraw=(y,b)=>{St=b||!1,y!==!1?Os(E,L.min,L.max):zn()};function pu(y,b){let D=S[y];if(D.from==null){if(nn==0){let F=D.range(n,b.min,b.max,y);b.min=F[0],b.max=F[1]}if(b.min>b.max){let F=b.min;b.min=b.max,b.max=F}if(nn>1&&b.min!=null&&b.max!=null&&b.max-b.min<1e-16)return;y==E&&D.distr==2&&nn>0&&(b.min=Hi(b.min,t[0]),b.max=Hi(b.max,t[0]),b.min==b.max&&b.max++),G[y]=b,at=!0,zn()}}n.setScale=pu;let mu,gu,Nr,Ur,Kd,jd,Fr,Or,Qd,tp,qe,je,Fs=!1,On=dt.drag,Pn=On.x,In=On.y;_t&&(dt.x&&(mu=Ai(UE,p)),dt.y&&(gu=Ai(FE,p)),L.ori==0?(Nr=mu,Ur=gu):(Nr=gu,Ur=mu),qe=dt.left,je=dt.top);let $e=n.select=xn({show:!0,over:!0,left:0,width:0,top:0,height:0},i.select),Br=$e.show?Ai(NE,$e.over?p:d):null;function ol(y,b){if($e.show){for(let D in y)$e[D]=y[D],D in yu&&Je(Br,D,y[D]);b!==!1&&Ln("setSelect")}}n.setSelect=ol;function Ax(y){if(v[y].show)Q&&xd(ce[y],Tr);else if(Q&&yi(ce[y],Tr),_t){let D=It?fe[0]:fe[y];D!=null&&hs(D,-10,-10,k,Lt)}}function Os(y,b,D){pu(y,{min:b,max:D})}function Yi(y,b,D,F){b.focus!=null&&Lx(y),b.show!=null&&v.forEach((W,j)=>{j>0&&(y==j||y==null)&&(W.show=b.show,Ax(j),s==2?(Os(W.facets[0].scale,null,null),Os(W.facets[1].scale,null,null)):Os(W.scale,null,null),zn())}),D!==!1&&Ln("setSeries",y,b),F&&$o("setSeries",n,y,b)}n.setSeries=Yi;function Cx(y,b){xn(R[y],b)}function Rx(y,b){y.fill=be(y.fill||null),y.dir=Ae(y.dir,-1),b=b??R.length,R.splice(b,0,y)}function Px(y){y==null?R.length=0:R.splice(y,1)}n.addBand=Rx,n.setBand=Cx,n.delBand=Px;function Ix(y,b){v[y].alpha=b,_t&&fe[y]!=null&&(fe[y].style.opacity=b),Q&&ce[y]&&(ce[y].style.opacity=b)}let ms,Bs,rr,kr={focus:!0};function Lx(y){if(y!=rr){let b=y==null,D=Vt.alpha!=1;v.forEach((F,W)=>{if(s==1||W>0){let j=b||W==0||W==y;F._focus=b?null:j,D&&Ix(W,j?1:Vt.alpha)}}),rr=y,D&&zn()}}Q&&ie&&we(C0,Pt,y=>{dt._lock||(ne(y),rr!=null&&Yi(null,kr,!0,gn.setSeries))});function Zi(y,b,D){let F=S[b];D&&(y=y/Ie-(F.ori==1?he:Qt));let W=k;F.ori==1&&(W=Lt,y=W-y),F.dir==-1&&(y=W-y);let j=F._min,lt=F._max,mt=y/W,Mt=j+(lt-j)*mt,Ft=F.distr;return Ft==3?Lo(10,Mt):Ft==4?QE(Mt,F.asinh):Ft==100?F.bwd(Mt):Mt}function Dx(y,b){let D=Zi(y,E,b);return Hi(D,t[0],cn,hn)}n.valToIdx=y=>Hi(y,t[0]),n.posToIdx=Dx,n.posToVal=Zi,n.valToPos=(y,b,D)=>S[b].ori==0?r(y,S[b],D?$:k,D?I:0):o(y,S[b],D?ft:Lt,D?M:0),n.setCursor=(y,b,D)=>{qe=y.left,je=y.top,or(null,b,D)};function ep(y,b){Je(Br,Ro,$e.left=y),Je(Br,Ja,$e.width=b)}function np(y,b){Je(Br,"top",$e.top=y),Je(Br,Ka,$e.height=b)}let Wo=L.ori==0?ep:np,Xo=L.ori==1?ep:np;function Nx(){if(Q&&pt.live)for(let y=s==2?1:0;y<v.length;y++){if(y==0&&de)continue;let b=pt.values[y],D=0;for(let F in b)Xt[y][D++].firstChild.nodeValue=b[F]}}function _u(y,b){if(y!=null&&(y.idxs?y.idxs.forEach((D,F)=>{st[F]=D}):i1(y.idx)||st.fill(y.idx),pt.idx=st[0]),Q&&pt.live){for(let D=0;D<v.length;D++)(D>0||s==1&&!de)&&Ux(D,st[D]);Nx()}gt=!1,b!==!1&&Ln("setLegend")}n.setLegend=_u;function Ux(y,b){let D=v[y],F=y==0&&z==2?ci:t[y],W;de?W=D.values(n,y,b)??ae:(W=D.value(n,b==null?null:F[b],y,b),W=W==null?ae:{_:W}),pt.values[y]=W}function or(y,b,D){Qd=qe,tp=je,[qe,je]=dt.move(n,qe,je),dt.left=qe,dt.top=je,_t&&(Nr&&hs(Nr,An(qe),0,k,Lt),Ur&&hs(Ur,0,An(je),k,Lt));let F,W=cn>hn;ms=Ve,Bs=null;let j=L.ori==0?k:Lt,lt=L.ori==1?k:Lt;if(qe<0||nn==0||W){F=dt.idx=null;for(let mt=0;mt<v.length;mt++){let Mt=fe[mt];Mt!=null&&hs(Mt,-10,-10,k,Lt)}ie&&Yi(null,kr,!0,y==null&&gn.setSeries),pt.live&&(st.fill(F),gt=!0)}else{let mt,Mt,Ft;s==1&&(mt=L.ori==0?qe:je,Mt=Zi(mt,E),F=dt.idx=Hi(Mt,t[0],cn,hn),Ft=O(t[0][F],L,j,0));let Ot=-10,kt=-10,le=0,Ce=0,Ee=!0,ve="",ee="";for(let Zt=s==2?1:0;Zt<v.length;Zt++){let Ye=v[Zt],rn=st[Zt],Dn=rn==null?null:s==1?t[Zt][rn]:t[Zt][1][rn],ke=dt.dataIdx(n,Zt,F,Mt),on=ke==null?null:s==1?t[Zt][ke]:t[Zt][1][ke];if(gt=gt||on!=Dn||ke!=rn,st[Zt]=ke,Zt>0&&Ye.show){let hi=ke==null?-10:ke==F?Ft:O(s==1?t[0][ke]:t[Zt][0][ke],L,j,0),qn=on==null?-10:P(on,s==1?S[Ye.scale]:S[Ye.facets[1].scale],lt,0);if(ie&&on!=null){let Mi=L.ori==1?qe:je,Pi=Cn(Vt.dist(n,Zt,ke,qn,Mi));if(Pi<ms){let Ji=Vt.bias;if(Ji!=0){let ui=Zi(Mi,Ye.scale),bi=on>=0?1:-1,Ii=ui>=0?1:-1;Ii==bi&&(Ii==1?Ji==1?on>=ui:on<=ui:Ji==1?on<=ui:on>=ui)&&(ms=Pi,Bs=Zt)}else ms=Pi,Bs=Zt}}if(gt||It){let Mi,Pi;L.ori==0?(Mi=hi,Pi=qn):(Mi=qn,Pi=hi);let Ji,ui,bi,Ii,Ki,$n,fi=!0,ar=ut.bbox;if(ar!=null){fi=!1;let Yn=ar(n,Zt);bi=Yn.left,Ii=Yn.top,Ji=Yn.width,ui=Yn.height}else bi=Mi,Ii=Pi,Ji=ui=ut.size(n,Zt);if($n=ut.fill(n,Zt),Ki=ut.stroke(n,Zt),It)Zt==Bs&&ms<=Vt.prox&&(Ot=bi,kt=Ii,le=Ji,Ce=ui,Ee=fi,ve=$n,ee=Ki);else{let Yn=fe[Zt];Yn!=null&&(Xe[Zt]=bi,Wn[Zt]=Ii,U0(Yn,Ji,ui,fi),D0(Yn,$n,Ki),hs(Yn,Ci(bi),Ci(Ii),k,Lt))}}}}if(It){let Zt=Vt.prox,Ye=rr==null?ms<=Zt:ms>Zt||Bs!=rr;if(gt||Ye){let rn=fe[0];rn!=null&&(Xe[0]=Ot,Wn[0]=kt,U0(rn,le,Ce,Ee),D0(rn,ve,ee),hs(rn,Ci(Ot),Ci(kt),k,Lt))}}}if($e.show&&Fs)if(y!=null){let[mt,Mt]=gn.scales,[Ft,Ot]=gn.match,[kt,le]=y.cursor.sync.scales,Ce=y.cursor.drag;if(Pn=Ce._x,In=Ce._y,Pn||In){let{left:Ee,top:ve,width:ee,height:Zt}=y.select,Ye=y.scales[kt].ori,rn=y.posToVal,Dn,ke,on,hi,qn,Mi=mt!=null&&Ft(mt,kt),Pi=Mt!=null&&Ot(Mt,le);Mi&&Pn?(Ye==0?(Dn=Ee,ke=ee):(Dn=ve,ke=Zt),on=S[mt],hi=O(rn(Dn,kt),on,j,0),qn=O(rn(Dn+ke,kt),on,j,0),Wo(Wi(hi,qn),Cn(qn-hi))):Wo(0,j),Pi&&In?(Ye==1?(Dn=Ee,ke=ee):(Dn=ve,ke=Zt),on=S[Mt],hi=P(rn(Dn,le),on,lt,0),qn=P(rn(Dn+ke,le),on,lt,0),Xo(Wi(hi,qn),Cn(qn-hi))):Xo(0,lt)}else vu()}else{let mt=Cn(Qd-Kd),Mt=Cn(tp-jd);if(L.ori==1){let le=mt;mt=Mt,Mt=le}Pn=On.x&&mt>=On.dist,In=On.y&&Mt>=On.dist;let Ft=On.uni;Ft!=null?Pn&&In&&(Pn=mt>=Ft,In=Mt>=Ft,!Pn&&!In&&(Mt>mt?In=!0:Pn=!0)):On.x&&On.y&&(Pn||In)&&(Pn=In=!0);let Ot,kt;Pn&&(L.ori==0?(Ot=Fr,kt=qe):(Ot=Or,kt=je),Wo(Wi(Ot,kt),Cn(kt-Ot)),In||Xo(0,lt)),In&&(L.ori==1?(Ot=Fr,kt=qe):(Ot=Or,kt=je),Xo(Wi(Ot,kt),Cn(kt-Ot)),Pn||Wo(0,j)),!Pn&&!In&&(Wo(0,0),Xo(0,0))}if(On._x=Pn,On._y=In,y==null){if(D){if(dp!=null){let[mt,Mt]=gn.scales;gn.values[0]=mt!=null?Zi(L.ori==0?qe:je,mt):null,gn.values[1]=Mt!=null?Zi(L.ori==1?qe:je,Mt):null}$o(hd,n,qe,je,k,Lt,F)}if(ie){let mt=D&&gn.setSeries,Mt=Vt.prox;rr==null?ms<=Mt&&Yi(Bs,kr,!0,mt):ms>Mt?Yi(null,kr,!0,mt):Bs!=rr&&Yi(Bs,kr,!0,mt)}}gt&&(pt.idx=F,_u()),b!==!1&&Ln("setCursor")}let ks=null;Object.defineProperty(n,"rect",{get(){return ks==null&&qo(!1),ks}});function qo(y=!1){y?ks=null:(ks=p.getBoundingClientRect(),Ln("syncRect",ks))}function ip(y,b,D,F,W,j,lt){dt._lock||Fs&&y!=null&&y.movementX==0&&y.movementY==0||(xu(y,b,D,F,W,j,lt,!1,y!=null),y!=null?or(null,!0,!0):or(b,!0,!1))}function xu(y,b,D,F,W,j,lt,mt,Mt){if(ks==null&&qo(!1),ne(y),y!=null)D=y.clientX-ks.left,F=y.clientY-ks.top;else{if(D<0||F<0){qe=-10,je=-10;return}let[Ft,Ot]=gn.scales,kt=b.cursor.sync,[le,Ce]=kt.values,[Ee,ve]=kt.scales,[ee,Zt]=gn.match,Ye=b.axes[0].side%2==1,rn=L.ori==0?k:Lt,Dn=L.ori==1?k:Lt,ke=Ye?j:W,on=Ye?W:j,hi=Ye?F:D,qn=Ye?D:F;if(Ee!=null?D=ee(Ft,Ee)?a(le,S[Ft],rn,0):-10:D=rn*(hi/ke),ve!=null?F=Zt(Ot,ve)?a(Ce,S[Ot],Dn,0):-10:F=Dn*(qn/on),L.ori==1){let Mi=D;D=F,F=Mi}}Mt&&(b==null||b.cursor.event.type==hd)&&((D<=1||D>=k-1)&&(D=br(D,k)),(F<=1||F>=Lt-1)&&(F=br(F,Lt))),mt?(Kd=D,jd=F,[Fr,Or]=dt.move(n,D,F)):(qe=D,je=F)}let yu={width:0,height:0,left:0,top:0};function vu(){ol(yu,!1)}let sp,rp,op,ap;function lp(y,b,D,F,W,j,lt){Fs=!0,Pn=In=On._x=On._y=!1,xu(y,b,D,F,W,j,lt,!0,!1),y!=null&&(we(ud,gd,cp,!1),$o(E0,n,Fr,Or,k,Lt,null));let{left:mt,top:Mt,width:Ft,height:Ot}=$e;sp=mt,rp=Mt,op=Ft,ap=Ot}function cp(y,b,D,F,W,j,lt){Fs=On._x=On._y=!1,xu(y,b,D,F,W,j,lt,!1,!0);let{left:mt,top:Mt,width:Ft,height:Ot}=$e,kt=Ft>0||Ot>0,le=sp!=mt||rp!=Mt||op!=Ft||ap!=Ot;if(kt&&le&&ol($e),On.setScale&&kt&&le){let Ce=mt,Ee=Ft,ve=Mt,ee=Ot;if(L.ori==1&&(Ce=Mt,Ee=Ot,ve=mt,ee=Ft),Pn&&Os(E,Zi(Ce,E),Zi(Ce+Ee,E)),In)for(let Zt in S){let Ye=S[Zt];Zt!=E&&Ye.from==null&&Ye.min!=Ve&&Os(Zt,Zi(ve+ee,Zt),Zi(ve,Zt))}vu()}else dt.lock&&(dt._lock=!dt._lock,or(b,!0,y!=null));y!=null&&(yn(ud,gd),$o(ud,n,qe,je,k,Lt,null))}function Fx(y,b,D,F,W,j,lt){if(dt._lock)return;ne(y);let mt=Fs;if(Fs){let Mt=!0,Ft=!0,Ot=10,kt,le;L.ori==0?(kt=Pn,le=In):(kt=In,le=Pn),kt&&le&&(Mt=qe<=Ot||qe>=k-Ot,Ft=je<=Ot||je>=Lt-Ot),kt&&Mt&&(qe=qe<Fr?0:k),le&&Ft&&(je=je<Or?0:Lt),or(null,!0,!0),Fs=!1}qe=-10,je=-10,st.fill(null),or(null,!0,!0),mt&&(Fs=mt)}function hp(y,b,D,F,W,j,lt){dt._lock||(ne(y),Ho(),vu(),y!=null&&$o(R0,n,qe,je,k,Lt,null))}function up(){A.forEach(yA),B(n.width,n.height,!0)}Er(jh,Io,up);let zr={};zr.mousedown=lp,zr.mousemove=ip,zr.mouseup=cp,zr.dblclick=hp,zr.setSeries=(y,b,D,F)=>{let W=gn.match[2];D=W(n,b,D),D!=-1&&Yi(D,F,!0,!1)},_t&&(we(E0,p,lp),we(hd,p,ip),we(A0,p,y=>{ne(y),qo(!1)}),we(C0,p,Fx),we(R0,p,hp),wd.add(n),n.syncRect=qo);let al=n.hooks=i.hooks||{};function Ln(y,b,D){Xn?Oe.push([y,b,D]):y in al&&al[y].forEach(F=>{F.call(null,n,b,D)})}(i.plugins||[]).forEach(y=>{for(let b in y.hooks)al[b]=(al[b]||[]).concat(y.hooks[b])});let fp=(y,b,D)=>D,gn=xn({key:null,setSeries:!1,filters:{pub:z0,sub:z0},scales:[E,v[1]?v[1].scale:null],match:[V0,V0,fp],values:[null,null]},dt.sync);gn.match.length==2&&gn.match.push(fp),dt.sync=gn;let dp=gn.key,Su=O_(dp);function $o(y,b,D,F,W,j,lt){gn.filters.pub(y,b,D,F,W,j,lt)&&Su.pub(y,b,D,F,W,j,lt)}Su.sub(n);function Ox(y,b,D,F,W,j,lt){gn.filters.sub(y,b,D,F,W,j,lt)&&zr[y](null,b,D,F,W,j,lt)}n.pub=Ox;function Bx(){Su.unsub(n),wd.delete(n),Rn.clear(),yd(jh,Io,up),c.remove(),Pt?.remove(),Ln("destroy")}n.destroy=Bx;function Mu(){Ln("init",i,t),Go(t||i.data,!1),G[E]?pu(E,G[E]):Ho(),rt=$e.show&&($e.width>0||$e.height>0),nt=gt=!0,B(i.width,i.height)}return v.forEach(Pr),A.forEach(us),e?e instanceof HTMLElement?(e.appendChild(c),Mu()):e(n,Mu):Mu(),n}kn.assign=xn;kn.fmtNum=Id;kn.rangeNum=Qh;kn.rangeLog=nu;kn.rangeAsinh=Rd;kn.orient=Cr;kn.pxRatio=Ie;kn.join=h1;kn.fmtDate=Dd,kn.tzDate=S1;kn.sync=O_;{kn.addGap=iA,kn.clipGaps=ru;let i=kn.paths={points:H_};i.linear=X_,i.stepped=oA,i.bars=aA,i.spline=cA}var Z_=20,vA=26,SA=["align","lower"],MA=["up","align x","align depth","approach","fine"];function J_(i){let t=bt("servo-plot"),e=[],n=[[],[],[]],s={stroke:"#9fb0bd",grid:{stroke:"#263642",width:1},ticks:{show:!1},font:"11px system-ui"},r=(d,p)=>({label:d,stroke:p,width:1.5,points:{show:!1}}),o=()=>({width:Math.max(t.clientWidth,120),height:Math.min(Math.max(t.clientHeight-vA,60),118)}),a=new kn({...o(),legend:{show:!0,live:!1},cursor:{show:!1},scales:{x:{time:!1,range:[-Z_,0]}},axes:[{...s,size:22,values:(d,p)=>p.map(_=>`${_} s`)},{...s,size:38}],series:[{},r("x px","#4fb3ff"),r("y px","#7fd18b"),r("d mm","#f2a33a")]},[[],[],[],[]],t);new ResizeObserver(()=>a.setSize(o())).observe(t);let l=()=>{for(let d of[e,...n])d.length=0},c=ii(()=>{let d=e[e.length-1];a.setData([e.map(p=>Math.round((p-d)*100)/100),...n]),t.classList.toggle("empty",e.length===0)}),f=!1,u,h=()=>{let[,d,p]=u??[],_=e.length?` since ${We(e[e.length-1]*1e6)}`:"";bt("servo-note").textContent=f&&u?`${MA[d]??d}: ${Y(p)}`:`at rest${_}`,t.classList.toggle("ended",!f),c()};i.follow("(micro-task ?i ?step ?state)",([d])=>{let[,,p,_]=d?ht(d):[];f=Y(_)==="running"&&SA.includes(Y(p[0])),h()}),i.follow("(servo ?state ?object ?x ?y ?d)",([d])=>{if(u=d&&ht(d),!d||!u)return l(),h();let p=d.facts[0].when/1e6;for(p<e[e.length-1]&&l(),e.push(p),u.slice(3).forEach((_,g)=>n[g].push(_));e[0]<p-Z_;)for(let _ of[e,...n])_.shift();h()})}var bA=1e3,wA="Escape, from anywhere",zd="use the button at the cell";function K_(i,t,e){let n=bt("stop-note"),s=h=>n.textContent=h,r=bt("stop-alarm"),o=h=>{r.textContent=h,r.hidden=h===""},a=async()=>{let h=setTimeout(()=>o(`STOP is not confirmed: ${zd}`),bA);try{await i.stop("the operator's STOP"),s("STOP is told"),o("")}catch(d){o(`STOP is not confirmed: ${zd} (${Te(d)})`)}clearTimeout(h)};bt("stop").addEventListener("click",a),bt("confirm-stop").addEventListener("click",()=>{a(),bt("confirm").close()});let l=h=>{h.key==="Escape"&&!h.repeat&&a()};window.addEventListener("keydown",l,{capture:!0});let c=bt("clear-stops");c.addEventListener("click",async()=>{if(await Sl("Is everybody out of the way? Clearing the stop lets the arm move again."))try{await i.clearStops()}catch(h){s(Te(h))}});let f=new Mn("why-not-cleared");c.after(f.note);let u=new Mn("why-no-stop");n.after(u.note),e.onChange(()=>{let h=t.right("clear-stops")||e.why;f.set("Clear",[c],h&&`${h}. Who clears a stop sets the arm free`);let d=t.right("stop");u.set("STOP",[bt("stop"),bt("confirm-stop")],d&&`${d}: ${zd}`)}),i.followAlways("(stop ?who ?reason)",h=>{bt("stopped").hidden=h.length===0,h.length>0?o(""):s(wA);let d=h.map(p=>`${ri(Y(ht(p)[1]),e.me)}: ${Y(ht(p)[2])}`);bt("stopped-by").textContent=$t(d.join("; "))})}function j_(i,t){let e=i.map(ht).filter(a=>a[1]<=t),n=e.findLast(([,,a,l])=>Y(a)==="operation"&&/^operation \d+:/.test(Y(l)));if(!n)return null;let s=Number(Y(n[3]).match(/\d+/)?.[0])-1,o=e.filter(a=>a[1]<n[1]).map(a=>gs(a[4])).findLast(a=>a&&a.operations[s]!==void 0&&te(a.operations[s])===te(n[4]));return o?{...o,step:s}:null}async function Q_(i,t,e){try{return{answers:await i.askThen(t,e),then:!0}}catch{return{answers:[],then:!1}}}async function TA(i,{goal:t,operations:e,step:n},s){let r=[zt("plan-needs"),zt("?n"),zt("?needs")],{answers:o,then:a}=await Q_(i,te(r),s),[l]=(a?o:await i.ask(r)).map(ht);return!l||l[1]!==t||l[2].length!==e.length+1?null:{before:l[2][n],after:l[2][n+1]}}var EA=(i,t)=>Array.isArray(i)&&Y(i[0])==="not"?!t.has(te(i[1])):t.has(te(i));function Vd(i,t){if(i.length===0)return"nothing";let e=i.map(n=>{let s=t&&EA(n,t),r=s===null?"":s?" holds":" does not hold";return C("li",{class:s===!1?"lacks":""},C("code",{},$t(te(n),120)),C("small",{class:"quiet"},r))});return C("ul",{class:"expected"},...e)}var AA=({operations:i,step:t})=>C("ol",{class:"ordered"},...i.map((e,n)=>C("li",{"aria-current":n===t?"step":null},C("code",{},$t(te(e),120))))),CA=i=>C("dl",{class:"why"},...i.flatMap(([t,e])=>[C("dt",{},t),C("dd",{},e)]));async function tx(i,t,e){let[,n,s]=ht(e),{when:r}=e.facts[0],o=j_(t,n);if(!o||!["operation","servo","difference","missing"].includes(Y(s)))return"";let[a]=(await i.ask([zt("goal"),o.goal,zt("?facts")])).map(ht),l=await Q_(i,"(believed ?fact)",r),c=l.answers.map(d=>ht(d)[1]),f=l.then?new Set(c.map(te)):null,u=await TA(i,o,r),h="not known: the plan is not there any more, and no journal has it";return CA([["Ordered by",`goal ${te(o.goal)}${a?`: ${$t(a[2].map(te).join(" "),300)}`:""}`],[`Step ${o.step+1} of ${o.operations.length}`,AA(o)],["Expected before",u?Vd(u.before,f):h],["Expected after",u?Vd(u.after,null):h],["Believed then",f?Vd(c,null):"not known: this board keeps no journal"]])}var Gd=50,RA={reached:"good",running:"busy",kept:"good"},PA=i=>Array.isArray(i)&&Y(i[0])==="fail"?Y(i[2]):"";function ex(i){let t=C("span",{class:"quiet"},""),e=C("tbody",{}),n=["","Goal","Outcome","Since"].map(l=>C("th",{},l)),s=C("table",{id:"goals"},C("thead",{},C("tr",{},...n)),e),r=new Map,o=new Map,a=()=>{let l=[...new Set([...r.keys(),...o.keys()])].sort((f,u)=>u-f);t.textContent=l.length>Gd?`${l.length}, ${Gd} shown`:String(l.length);let c=l.slice(0,Gd).map(f=>{let u=o.get(f),h=u?Y(ht(u)[2]):"asked for",d=u?PA(ht(u)[3]):"";return C("tr",{},C("td",{},String(f)),C("td",{},C("code",{},$t((r.get(f)??[]).map(te).join(" "),200))),C("td",{},C("span",{class:`chip ${RA[h]??"warn"}`},h),d&&` ${$t(d)}`),C("td",{},u?We(u.facts[0].when):""))});e.replaceChildren(...c)};return i.follow("(goal ?n ?facts)",l=>{r=new Map(l.map(ht).map(([,c,f])=>[c,f])),a()}),i.follow("(goal-state ?n ?state ?detail)",l=>{o=new Map(l.map(c=>[ht(c)[1],c])),a()}),C("details",{class:"goals"},C("summary",{},"Goals so far ",t),s)}function nx(i,t,e){let n=C("canvas",{role:"img","aria-label":`What was seen at ${We(e)}`,hidden:!0}),s=C("figcaption",{class:"quiet"},"looking for the picture \u2026");return(async()=>{if(!t)return s.textContent="no stream of images is told";try{let o=await i.picture(t,e);Dl(n,o),o.bitmap.close(),n.hidden=!1,s.textContent=`frame ${o.number}, ${We(o.captured)}`}catch(o){s.textContent=Te(o)}})(),C("figure",{class:"kept"},n,s)}var IA=4e3,Hd=({answer:i})=>i.facts[0].when,cu=class{#e={servo:new Map,sightings:new Map};#t=null;#n;constructor(t,e){this.#n=e,t.followAlways("(servo ?state ?object ?x ?y ?d)",([n])=>this.#r(n)),t.followAlways("(tracked ?eyes ?name ?state ?frame ?confidence)",n=>{for(let s of n)this.#s("sightings",{answer:s,until:s.facts[0].when});e()}),t.earlierWork((n,s)=>{for(let r of s)this.#s(n,r);e()})}servo(t){return this.#i("servo",t)}sightings(t){return this.#i("sightings",t)}#i(t,e){return[...this.#e[t].values()].filter(n=>Hd(n)<=e)}#s(t,e){let n=this.#e[t];if(n.set(e.answer.ids[0],e),n.size<=IA)return;let s=[...n].reduce((r,o)=>Hd(o[1])<Hd(r[1])?o:r);n.delete(s[0])}#r(t){let e=n=>ht(n).slice(1,3).join(" ");t&&this.#t&&(this.#t.until=t.facts[0].when),t?(!this.#t||e(this.#t.answer)!==e(t))&&(this.#t={answer:t,until:t.facts[0].when},this.#s("servo",this.#t)):this.#t=null,this.#n()}};var Is=["Goals","Plans","Operations","Servo","Sightings","Differences","Refusals","Faults"],LA=["up","align x","align depth","approach","fine"],DA={plan:"Plans",operation:"Operations",servo:"Servo",difference:"Differences",missing:"Differences",agent:"Faults"},NA=new Set(["operation","plan","result","goal"]),ir=i=>i.facts[0].when,UA=i=>Array.isArray(i)&&Y(i[0])==="fail";function ix(i){let t=i.map(e=>({answer:e,event:ht(e),when:ir(e)}));return t.flatMap(({answer:e,event:[,,n,s,r],when:o},a)=>{let l=UA(r),c=l?"Faults":DA[Y(n)];if(!c)return[];let f=c==="Operations"&&t.slice(a+1).find(({event:u})=>NA.has(Y(u[2])));return[{lane:c,from:o,until:f?f.when:o,kind:l?"bad":Y(n),label:Y(s),answer:e}]})}function sx(i,t,e){let n=new Map(t.map(s=>[ht(s)[1],s]));return i.flatMap(s=>{let[,r,o]=ht(s),a=n.get(r),l=a?Y(ht(a)[2]):"asked for",c=`goal ${r} ${l}: ${o.map(te).join(" ")}`,f=a&&l!=="running"?ir(a):e,u={lane:"Goals",from:ir(s),until:f,kind:l,label:c,answer:a??s};return l==="refused"?[u,{...u,lane:"Refusals",from:f,kind:"bad"}]:[u]})}function rx(i){return i.map(t=>{let[,e,n,s,r]=ht(t),o=`${Y(e)}: ${Y(n)}, ${s} times: ${Y(r)}`;return{lane:"Refusals",from:ir(t),until:ir(t),kind:"bad",label:o,answer:t}})}function ox(i){return i.map(({answer:t})=>{let[,e,n,s,r]=ht(t),o=`${Y(e)}: ${Y(n)} ${Y(s)} since frame ${r}`;return{lane:"Sightings",from:ir(t),until:ir(t),kind:Y(s),label:o,answer:t}})}function ax(i){return i.map(({answer:t,until:e})=>{let[,n,s]=ht(t),r=`servo ${LA[n]??n}: ${Y(s)}`;return{lane:"Servo",from:ir(t),until:e,kind:`state-${n}`,label:r,answer:t}})}function lx(i,t){let e=[],n=new Map;for(let s of i.toSorted((r,o)=>r.from-o.from)){let r=`${s.lane} ${s.kind}`,o=n.get(r);if(o&&s.from-o.from<t)o.marks.push(s),o.until=Math.max(o.until,s.until);else{let a={lane:s.lane,kind:s.kind,from:s.from,until:s.until,marks:[s]};n.set(r,a),e.push(a)}}return e}var hu=76,Rr=19,ko=18,cx=5,FA=24,ux=1e6,fx=60*ux,Wd=[30*ux,...[1,2,5,10,20,60,120].map(i=>i*fx)],OA=(i,t)=>t<fx?We(i):We(i).slice(0,5);function hx({lane:i,marks:t,from:e}){let n=t.length>1?` and ${t.length-1} more`:"";return`${i}, ${We(e)}: ${$t(t[0].label,160)}${n}`}var BA={ArrowLeft:[-1,0],ArrowRight:[1,0],ArrowUp:[0,-1],ArrowDown:[0,1]},uu=class{#e;#t=Sn("g",{});#n=Sn("g",{});#i=new Map;#s="";panel;constructor(t){this.#e=t;let e=ko+Is.length*Rr;this.panel=Sn("svg",{id:"work",height:e,width:"100%",role:"group","aria-label":"What happened, over time"},this.#t,this.#n),this.panel.addEventListener("keydown",n=>this.#f(n))}draw(t,e,n){let s=Math.max(this.panel.clientWidth-hu-4,100),r=c=>hu+s*(Math.min(Math.max(c,e),n)-e)/(n-e),o=t.filter(c=>c.until>=e&&c.from<=n),a=lx(o,cx*(n-e)/s);this.#r(r,s,e,n);let l=new Map(a.map(c=>[`${c.lane} ${c.kind} ${c.from}`,c]));for(let[c,{made:f}]of this.#i)l.has(c)||(f.remove(),this.#i.delete(c));for(let[c,f]of l)this.#o(c,f,r);this.#c()}#r(t,e,n,s){let r=Wd.find(l=>(s-n)/l<=8)??Wd[Wd.length-1],o=[];for(let l=Math.ceil(n/r)*r;l<=s;l+=r)o.push(l);let a=ko+Is.length*Rr;this.#t.replaceChildren(...Is.map((l,c)=>Sn("text",{x:0,y:ko+c*Rr+13,class:"lane"},l)),...Is.map((l,c)=>Sn("rect",{x:hu,y:ko+c*Rr+1,width:e,height:Rr-2,class:"lane"})),...o.map(l=>Sn("line",{x1:t(l),x2:t(l),y1:ko,y2:a,class:"tick"})),...o.filter(l=>t(l)<hu+e-FA).map(l=>Sn("text",{x:t(l),y:12,class:"tick"},OA(l,r))))}#o(t,e,n){let s=this.#i.get(t)??this.#a(t,e);s.group=e,s.title.textContent=hx(e);let{made:r}=s,o=n(e.from);r.setAttribute("x",String(o)),r.setAttribute("y",String(ko+Is.indexOf(e.lane)*Rr+3)),r.setAttribute("width",String(Math.max(n(e.until)-o,cx))),r.setAttribute("aria-label",hx(e))}#a(t,e){let n=Sn("title",{}),s=Sn("rect",{height:Rr-6,rx:2,role:"button",tabindex:-1,class:`mark ${e.kind}`,"data-lane":e.lane},n);s.addEventListener("click",()=>this.#l(t)),s.addEventListener("focus",()=>{this.#s=t,this.#c()}),this.#n.append(s);let r={made:s,title:n,group:e};return this.#i.set(t,r),r}#l(t){let e=this.#i.get(t);e&&this.#e(e.group.marks)}#c(){this.#i.has(this.#s)||(this.#s=this.#h().at(-1)?.[0]??"");for(let[t,{made:e}]of this.#i)e.setAttribute("tabindex",t===this.#s?"0":"-1")}#h(){return[...this.#i].sort(([,t],[,e])=>t.group.from-e.group.from)}#f(t){let e=this.#i.get(this.#s);if(!e)return;if(t.key==="Enter"||t.key===" ")return t.preventDefault(),this.#l(this.#s);let n=BA[t.key],s=n&&(n[0]?this.#d(e,n[0]):this.#u(e,n[1]));s&&(t.preventDefault(),s.made.focus())}#d(t,e){let n=this.#h().filter(([,{group:s}])=>s.lane===t.group.lane);return n[n.findIndex(([,s])=>s===t)+e]?.[1]}#u(t,e){let n=({group:s})=>Math.abs(s.from-t.group.from);for(let s=Is.indexOf(t.group.lane)+e;s>=0&&s<Is.length;s+=e){let r=[...this.#i.values()].filter(({group:o})=>o.lane===Is[s]);if(r.length)return r.sort((o,a)=>n(o)-n(a))[0]}}};var kA=[["2 minutes",12e7],["10 minutes",6e8],["1 hour",36e8],["8 hours",8*36e8]],Xd=20,zA=5e3;function dx(i,t,e){let n=C("div",{class:"timeline",id:"opened",hidden:!0}),s=({answer:d,label:p})=>C("details",{},C("summary",{},C("time",{},We(d.facts[0].when)),$t(p)),C("p",{class:"quiet"},Wr(d.ids[0],d.facts[0]))),r=d=>{let p=d.slice(0,Xd).map(m=>ht(m.answer)[0].name==="event"?e(m.answer):s(m)),_=d.length>Xd?[C("p",{class:"quiet"},`and ${d.length-Xd} more`)]:[],g=C("button",{type:"button",class:"small",onclick:()=>n.hidden=!0},"Close");n.replaceChildren(g,...p,..._),n.hidden=!1,p[0].open=!0},o=new uu(r),a=C("select",{"aria-label":"How much of the past"},...kA.map(([d,p])=>C("option",{value:p,selected:d==="10 minutes"},d))),l={goals:[],states:[],refusals:[]},c=ii(()=>{if(o.panel.clientWidth===0)return;let d=i.moment??Date.now()*1e3,p=d-Number(a.value);t.reach(p);let _=[...sx(l.goals,l.states,d),...ix(t.until(d)),...ax(f.servo(d)),...ox(f.sightings(d)),...rx(l.refusals)];o.draw(_,p,d)}),f=new cu(i,c),u=(d,p)=>i.follow(d,_=>{l[p]=_,c()});return u("(goal ?n ?facts)","goals"),u("(goal-state ?n ?state ?detail)","states"),u("(board-refusal ?client ?symbol ?count ?sentence)","refusals"),a.addEventListener("change",c),new ResizeObserver(c).observe(o.panel),setInterval(c,zA),{panel:C("section",{"aria-label":"Over time"},C("div",{class:"row"},C("h2",{},"Over time"),C("label",{},"The last ",a)),o.panel,n),draw:c}}var px="(event ?n ?kind ?sentence ?detail)",qd=5e3,sr=i=>i.facts[0].when,nl=i=>`${ht(i)[1]}@${sr(i)}`,fu=class{#e;#t=new Map;#n=!1;#i=!1;#s=[];constructor(t){this.#e=t,t.follow(px,e=>{this.#o(e),this.#r()})}onChange(t){this.#s.push(t)}#r(){for(let t of this.#s)t()}until(t){return[...this.#t.values()].filter(n=>sr(n)<=t).sort((n,s)=>sr(n)-sr(s)||ht(n)[1]-ht(s)[1])}async reach(t){if(!(this.#n||this.#i)){for(this.#n=!0;!this.#i&&this.#t.size<qd;){let e=this.until(1/0)[0];if(!e||ht(e)[1]<=1||sr(e)<=t)break;let n=this.#t.size;this.#o(await this.#e.askThen(px,sr(e)).catch(()=>[])),this.#i=this.#t.size===n,this.#r()}this.#n=!1}}#o(t){for(let n of t)this.#t.set(nl(n),n);if(this.#t.size<=qd)return;let e=[...this.#t].sort(([,n],[,s])=>sr(n)-sr(s)).slice(0,this.#t.size-qd);for(let[n]of e)this.#t.delete(n)}};var VA=200;function GA(i,t,e){let n=i.map(ht).filter(a=>a[1]<t),s=n.filter(a=>gs(a[4])?.goal===e).toSorted((a,l)=>l[1]-a[1])[0],r=s&&gs(s[4]);if(!r)return null;let o=n.filter(a=>a[1]>s[1]&&Y(a[2])==="operation").map(a=>te(a[4]));return{operations:r.operations,begun:new Set(o)}}function HA(i,t,e){let n=gs(e),s=n&&GA(i,t,n.goal);return s?lm(s.operations,n.operations,s.begun):C("pre",{},$t(te(e),4e3))}function WA({connection:i,images:t},e,n,s){let[,r,o,a,l]=ht(s),c=s.facts[0],f=C("summary",{},C("time",{},We(c.when)),C("span",{class:`kind ${Y(o)}`},Y(o)),C("span",{},$t(Y(a)))),u=C("div",{}),h=C("div",{});return C("details",{"data-number":r,ontoggle:async({target:p})=>{p.open&&(u.replaceChildren(nx(i,t.telling(),c.when)),h.replaceChildren(await tx(i,n,s)))}},f,C("p",{class:"quiet"},Wr(s.ids[0],c)),C("button",{type:"button",class:"small",onclick:()=>e(c.when)},"Show all as it was then"),u,h,Yp(i,s.ids[0],c),HA(n,r,l))}function mx(i,t){let{connection:e,permission:n,entries:s}=i,r=C("div",{class:"timeline"}),o=C("pre",{class:"answer",hidden:!0}),a=async()=>{o.hidden=!1;try{o.textContent=(await e.request("coordinator","(why)")).map(g=>$t(g,1e3)).join(`
`)}catch(g){o.textContent=Te(g)}},l=()=>s.until(e.moment??1/0),c=g=>WA(i,t,l(),g),f=dx(e,s,c),u=C("button",{type:"button",id:"why",onclick:a},"Why this, now?"),h=new Mn("why-not-asked");n.onChange(()=>h.set("Why this",[u],n.line||n.right("request"))),bt("story").append(C("div",{class:"row"},u,h.note),o,f.panel,ex(e),r);let d=new Map,p=g=>{let m=d.get(nl(g))??c(g);return d.set(nl(g),m),m},_=ii(()=>{let g=l().reverse().slice(0,VA),m=new Set(g.map(nl));for(let v of d.keys())m.has(v)||d.delete(v);cl(r,g.map(p)),f.draw()});s.onChange(_)}var XA={ArrowRight:1,ArrowLeft:-1};function gx(){let i=[...document.querySelectorAll("[role=tab]")].filter(e=>e instanceof HTMLElement),t=e=>{for(let n of i)n.setAttribute("aria-selected",String(n===e)),n.tabIndex=n===e?0:-1,bt(n.getAttribute("aria-controls")??"").hidden=n!==e};for(let e of i)e.addEventListener("click",()=>t(e)),e.addEventListener("keydown",n=>{let s=XA[n.key];if(!s)return;let r=i.filter(a=>!a.hidden),o=r[(r.indexOf(e)+s+r.length)%r.length];t(o),o.focus()});t(i[0])}var qA=12;function _x(i,t){let e=C("ul",{id:`${i.id}-words`,class:"words",role:"listbox","aria-label":"What may come next",hidden:!0});i.after(e);for(let[u,h]of Object.entries({role:"combobox","aria-autocomplete":"list","aria-expanded":"false","aria-controls":e.id}))i.setAttribute(u,h);let n={from:0,words:[]},s=-1,r=()=>i.selectionStart??0,o=u=>{if(s=u,[...e.children].forEach((h,d)=>h.setAttribute("aria-selected",String(d===s))),s<0)return i.removeAttribute("aria-activedescendant");i.setAttribute("aria-activedescendant",e.children[s].id),e.children[s].scrollIntoView({block:"nearest"})},a=()=>{e.hidden=!0,o(-1),i.setAttribute("aria-expanded","false")},l=u=>{let h=r();i.setRangeText(n.words[u].put,n.from,h,"end"),i.dispatchEvent(new Event("input",{bubbles:!0}))},c=()=>{n=t(i.value.slice(0,r()));let u=n.words.slice(0,qA).map(({word:h},d)=>{let p=C("li",{role:"option",id:`${e.id}-${d}`,"aria-selected":"false"},h);return p.addEventListener("pointerdown",_=>{_.preventDefault(),l(d)}),p});if(e.replaceChildren(...u),u.length===0)return a();e.hidden=!1,i.setAttribute("aria-expanded","true"),o(-1)},f=()=>r()>n.from;i.addEventListener("input",c),i.addEventListener("blur",a),i.addEventListener("keydown",u=>{let h=e.children.length;e.hidden?u.key==="ArrowDown"&&c():u.key==="ArrowDown"||u.key==="ArrowUp"?(u.preventDefault(),o((s+(u.key==="ArrowDown"?1:s<0?0:-1)+h)%h)):u.key==="Enter"&&s>=0||u.key==="Tab"&&!u.shiftKey&&(s>=0||f())?(u.preventDefault(),l(Math.max(s,0))):(u.key==="Enter"||u.key==="Escape")&&a()})}var xx=["and","or","not","then","keep"];function $A(i){let t=[];for(let[r]of i.matchAll(/[()]|[^\s()]+/g))r==="("?t.push([]):r===")"?(t.pop(),t.at(-1)?.push("()")):t.at(-1)?.push(r);let e=t.at(-1);if(!e)return null;let[n="",...s]=e;return{head:n,rest:s}}function yx(i,{predicates:t,names:e}){let n=i.match(/[^\s()]*$/)?.[0]??"",s=i.slice(0,i.length-n.length),r=$A(s),o=[...t.keys(),...xx],a=(h,d)=>h.filter(p=>p!==n&&p.startsWith(n.toLowerCase())).map(p=>({word:p,put:d(p)})),l=h=>({from:s.length,words:h});if(!r&&n===""&&s.trim()!=="")return l([]);if(!r||xx.includes(r.head))return l(a(o,h=>`(${h} `));if(r.head==="")return l(a(o,h=>`${h}${t.get(h)===0?")":" "}`));let c=t.get(r.head.toLowerCase());if(c===void 0)return l(a(e,h=>`${h} `));let f=c-r.rest.length;if(f<=0)return l([]);let u=e.filter(h=>!r.rest.includes(h));return l(a(u,h=>`${h}${f===1?")":" "}`))}var vx="the table",YA=16,$d=class{#e=[];#t=new Map;#n="";#i="";#s=C("div",{class:"towers",role:"group","aria-label":"Towers"});panel=C("div",{id:"sketch",hidden:!0});constructor(t){this.written=t;let e=C("button",{type:"button",onclick:()=>this.#c()},"Clear");this.panel.append(this.#s,C("div",{class:"row"},C("span",{class:"quiet"},"Drag a block onto another."),e)),this.#s.addEventListener("pointerup",n=>this.#h(n)),this.#s.addEventListener("pointercancel",()=>this.#i="")}setNames(t){this.#e=t.slice(0,YA);for(let[e,n]of this.#t)(!this.#e.includes(e)||!this.#e.includes(n))&&this.#t.delete(e);this.#u()}#r(t){return[...this.#t].find(([,e])=>e===t)?.[0]}#o(t){let e=this.#r(t);return e?[t,...this.#o(e)]:[t]}#a(t,e){if(this.#n="",e===vx)this.#t.delete(t);else if(t!==e&&!this.#o(t).includes(e)){let n=this.#l(e);this.#t.delete(t),this.#t.set(t,this.#o(n).at(-1)??n)}this.#u(),this.written(this.#e.flatMap(n=>this.#t.has(n)?[`(on ${n} ${this.#t.get(n)})`]:[]).join(" "))}#l(t){let e=this.#t.get(t);return e===void 0?t:this.#l(e)}#c(){this.#t.clear(),this.#n="",this.#u(),this.written("")}#h(t){let e=this.#i;if(this.#i="",!e)return;let n=document.elementFromPoint(t.clientX,t.clientY)?.closest("[data-block], .towers"),s=n&&(n.getAttribute("data-block")??vx);s&&s!==e&&this.#a(e,s)}#f(t){if(this.#n&&this.#n!==t)return this.#a(this.#n,t);this.#n=this.#n?"":t,this.#u()}#d(t){let e=C("button",{type:"button",class:"block","data-block":t,"aria-pressed":String(t===this.#n)},$t(t,20));return e.addEventListener("pointerdown",n=>{this.#i=t,e.releasePointerCapture?.(n.pointerId)}),e.addEventListener("click",()=>this.#f(t)),e}#u(){let t=this.#e.filter(e=>!this.#t.has(e));this.#s.replaceChildren(...t.map(e=>C("div",{class:"tower"},...this.#o(e).toReversed().map(n=>this.#d(n)))))}};function Sx(){let i=new $d(n=>bt("goal-text").value=n),t=C("button",{type:"button",id:"sketch-toggle","aria-expanded":"false","aria-controls":"sketch"},"Sketch"),e=n=>{i.panel.hidden=!n,t.setAttribute("aria-expanded",String(n))};return t.addEventListener("click",()=>e(!!i.panel.hidden)),bt("goal-form").addEventListener("submit",()=>e(!1)),bt("cancel").before(t),bt("goal-answer").before(i.panel),i}var ZA="end-effector";function JA(i,t){let e=Number(t.place?.match(/^goal:1:(\d+)/)?.[1]??0);if(i.setAttribute("aria-invalid","true"),e===0)return;let n=i.value.slice(e-1).match(/^[()]|^[^\s()]+/)?.[0]??" ";i.focus(),i.setSelectionRange(e-1,e-1+n.length)}function KA(i){let t=new Map;for(let[,,e]of i.map(ht)){let n=r=>e.filter(o=>Y(o[0])===r).flatMap(o=>o.slice(1));if(!n("offers").some(r=>Y(r[0])==="goal"))continue;let s=new Set(n("reads").map(Y));for(let[,r,o,...a]of n("posts"))s.has(Y(r))&&o.every(([,c])=>Y(c)==="symbol")&&!a.some(c=>Y(c[0])==="durable")&&t.set(Y(r),o.length)}return t}function Mx(i,t){let e=Sx(),n=bt("goal-answer"),s=bt("goal-text"),r=(d,p="")=>{n.hidden=!1,n.className=p,n.textContent=d},o=async d=>{r("asking \u2026"),s.removeAttribute("aria-invalid");try{let[p]=await i.goal(d,_=>{"error"in _?r(Te(_.error),"bad"):r(`goal ${p} ${_.values[0]}`,_.values[0]==="reached"?"good":"")});r(`goal ${p} accepted`)}catch(p){r(Te(p),"bad"),JA(s,p)}};bt("goal-form").addEventListener("submit",d=>{d.preventDefault(),o(s.value)}),bt("cancel").addEventListener("click",async()=>{try{await i.request("coordinator","(cancel)")}catch(d){r(Te(d),"bad")}});let a=new Mn("why-want");bt("goal-form").append(a.note);let l=!1,c=()=>{a.set("Go",[bt("go")],t.command("goal")),a.set("Cancel",[bt("cancel")],t.command("request")||(l?"":"no goal is running"))};t.onChange(c),i.follow("(goal-state ?n ?state ?detail)",d=>{let p=d.map(ht).toSorted((m,v)=>v[1]-m[1])[0],_=bt("goal-chip");_.hidden=!p;let g=p?Y(p[2]):"";l=g==="running",document.body.dataset.goal=g,c(),p&&(_.textContent=`goal ${p[1]}: ${g}`,_.className=`chip ${g==="reached"?"good":g==="running"?"busy":"warn"}`)});let f=[],u=[],h=new Map;i.follow("(contract ?name ?form)",d=>h=KA(d)),i.follow("(believed ?fact)",d=>u=d.flatMap(p=>ht(p)[1].slice(1).map(Y))),i.follow("(learned ?eyes ?name 1 ? ? ? ? ? ?)",d=>{f=d.map(p=>Y(ht(p)[2])).filter(p=>p!==ZA&&Rl(p)),e.setNames([...new Set(f)].slice(0,12))}),_x(s,d=>yx(d,{predicates:h,names:[...new Set([...f,...u])].sort()}))}var ln=new vl,Ds=new Nl,Ls=new Ml(ln,Ds),il=new El(ln),Yd=new ul;gx();var jA=nm(ln),QA=rm(Ds);K_(ln,Ds,Ls);Qp(Ls);var wx=M0(ln,il,Yd),Zd=sm(ln,il),Tx=new fu(ln);Mx(ln,Ds);hm(ln,Tx);J_(ln);var bx={connection:ln,permission:Ds,entries:Tx,images:Zd};mx(bx,am(bx));em(ln,Ds,Zd,()=>Ls.me);Xp({connection:ln,permission:Ds,images:Zd,roles:il},()=>Ls.me);kp({connection:ln,permission:Ds,hands:Ls,axes:Yd});var Ex=new ll(ln);jp(ln,Ex);Ap(ln,Ex);Pp(ln);ln.onArm=wx.moveArm;ln.onHello=i=>{bt("cell").textContent=i.cell,Ls.me=i.name,Ds.set({mayNot:i.mayNot}),Yd.set(i.axes),wx.setCell(i)};il.onChange(()=>{Ls.robot=il.server("robot")||Ls.robot,Ls.changed()});ln.onState=(i,t)=>{QA(i,t),jA(i,t)};ln.open();
